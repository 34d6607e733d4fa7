// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/mend.h"

#include "filters/geometry/consistent_surface.h"
#include "filters/geometry/half_edges.h"
#include "filters/geometry/intersecting.h"
#include "filters/geometry/mend_surface.h"
#include "filters/geometry/patch_refill.h"
#include "filters/geometry/point_triangle.h"
#include "filters/geometry/seams.h"
#include "filters/geometry/spikes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace scan
{
namespace
{

constexpr int kSpikePasses = 5;
constexpr std::size_t kRingsAround = 2; // of a defect that is repaired alone

/// Leaves out defects without a chosen triangle.
void keepChosen(DefectList& list, std::span<const std::uint8_t> isChosen)
{
  std::erase_if(list.defects,
    [&](const Defect& defect)
    { return std::ranges::none_of(defect.triangles, [&](Index t) { return isChosen[t] != 0; }); });
}

/// Leaves only the defect nearest to a place.
void keepNearest(DefectList& list, const TriMesh& mesh, const Vec3& at)
{
  const auto distance = [&](const Defect& defect)
  {
    double least = std::numeric_limits<double>::infinity();
    for (const Index t : defect.triangles)
    {
      const auto& [a, b, c] = mesh.triangles[t];
      least = std::min(least, squaredDistance(at, mesh.points[a], mesh.points[b], mesh.points[c]));
    }
    return least;
  };
  if (list.defects.size() > 1)
  {
    const auto nearest = std::ranges::min_element(list.defects, {}, distance);
    list.defects = { Defect(*nearest) };
  }
}

/// How many triangles are in defects; those in several count as often.
std::size_t extentOf(const DefectList& list)
{
  std::size_t sum = 0;
  for (const Defect& defect : list.defects)
  {
    sum += defect.triangles.size();
  }
  return sum;
}

class Mender
{
public:
  Mender(const TriMesh& mesh, std::span<const std::uint8_t> inRegion, const MendOptions& options,
    Execution& execution)
    : Input(mesh)
    , Options(options)
    , Run(execution)
    , Surface(mesh, { inRegion.begin(), inRegion.end() })
  {
  }

  MendResult run();

private:
  DefectList find();
  bool repair();
  bool isListed(DefectKind kind) const { return this->Listed.count(kind) > 0; }
  bool closeTornSeams();
  bool becomeConsistent();
  bool apply(ConsistentSurface&& surface);
  ConsistentSurface consistentPart(const ConsistentOptions& options);
  bool moveSpikes();
  bool removeComponents();
  bool fillHoles();
  void measureMoves();

  const TriMesh& Input;
  MendOptions Options;
  Execution& Run;
  MendSurface Surface;
  DefectList Listed;
  MendTally Tally;
};

DefectList Mender::find()
{
  DefectList list = findDefects(this->Surface.mesh, this->Options.defects, this->Run);
  keepChosen(list, this->Surface.isActive);
  return list;
}

bool Mender::closeTornSeams()
{
  if (!this->isListed(DefectKind::seams))
  {
    return false;
  }
  TriMesh& mesh = this->Surface.mesh;
  std::vector<SeamEdge> seams = findSeams(mesh, pairEdges(mesh, this->Run));
  std::erase_if(seams,
    [&](const SeamEdge& seam) {
      return this->Surface.isActive[seam[0] / 3] == 0 && this->Surface.isActive[seam[1] / 3] == 0;
    });
  closeSeams(mesh, seams);
  this->Tally.seamsClosed += seams.size();
  return !seams.empty();
}

/// What makeConsistent() makes of the active triangles and those around them, amid the others.
ConsistentSurface Mender::consistentPart(const ConsistentOptions& options)
{
  const TriMesh& mesh = this->Surface.mesh;
  std::vector<Index> active;
  for (Index t = 0; t < this->Surface.isActive.size(); ++t)
  {
    if (this->Surface.isActive[t] != 0)
    {
      active.push_back(t);
    }
  }
  const std::vector<std::uint8_t> isIn = withRings(mesh, active, kRingsAround, this->Run);
  std::vector<std::uint8_t> isOutside(mesh.points.size(), 0);
  std::map<Index, Index> number;
  TriMesh part;
  std::vector<Index> names;
  std::vector<Index> members;
  for (Index t = 0; t < isIn.size(); ++t)
  {
    Triangle corners = mesh.triangles[t];
    if (isIn[t] == 0)
    {
      std::ranges::for_each(corners, [&](Index point) { isOutside[point] = 1; });
      continue;
    }
    members.push_back(t);
    for (Index& corner : corners)
    {
      const auto [at, isNew] = number.emplace(corner, static_cast<Index>(names.size()));
      if (isNew)
      {
        names.push_back(corner);
        part.points.push_back(mesh.points[corner]);
      }
      corner = at->second;
    }
    part.triangles.push_back(corners);
  }
  ConsistentSurface surface = makeConsistent(std::move(part), options, this->Run);
  const std::size_t old = names.size();
  ConsistentSurface whole{ .mesh = { mesh.points, {} }, .changes = surface.changes };
  for (Index p = 0; p < mesh.points.size(); ++p)
  {
    whole.pointOrigin.push_back(p);
  }
  for (std::size_t p = old; p < surface.pointOrigin.size(); ++p)
  {
    const Index from = names[surface.pointOrigin[p]];
    if (isOutside[from] != 0) // at the border nothing is split: others hold on to it
    {
      names.push_back(from);
      continue;
    }
    names.push_back(static_cast<Index>(whole.mesh.points.size()));
    whole.mesh.points.push_back(surface.mesh.points[p]);
    whole.pointOrigin.push_back(from);
  }
  std::size_t next = 0;
  for (Index t = 0; t < isIn.size(); ++t)
  {
    if (isIn[t] == 0)
    {
      whole.mesh.triangles.push_back(mesh.triangles[t]);
      whole.triangleOrigin.push_back(t);
      continue;
    }
    for (; next < surface.triangleOrigin.size() && members[surface.triangleOrigin[next]] == t;
         ++next)
    {
      Triangle corners = surface.mesh.triangles[next];
      std::ranges::for_each(corners, [&](Index& corner) { corner = names[corner]; });
      whole.mesh.triangles.push_back(corners);
      whole.triangleOrigin.push_back(t);
    }
  }
  return whole;
}

bool Mender::becomeConsistent()
{
  const bool isSplit =
    this->isListed(DefectKind::nonManifoldEdges) || this->isListed(DefectKind::nonManifoldPoints);
  const ConsistentOptions options{
    .leastHeight = std::min(this->Options.defects.leastHeight, this->Options.maxDeviation),
    .repeats = this->isListed(DefectKind::duplicates),
    .flat = this->isListed(DefectKind::degenerate),
    .orient = isSplit || this->isListed(DefectKind::inverted),
    .split = isSplit || this->isListed(DefectKind::inverted),
  };
  if (!options.repeats && !options.flat && !options.orient)
  {
    return false;
  }
  const bool isWhole = std::ranges::find(this->Surface.isActive, 0) == this->Surface.isActive.end();
  return this->apply(isWhole ? makeConsistent(this->Surface.mesh, options, this->Run)
                             : this->consistentPart(options));
}

bool Mender::apply(ConsistentSurface&& surface)
{
  const SurfaceChanges& changes = surface.changes;
  const std::size_t before = this->Surface.mesh.triangles.size();
  const bool isSame = surface.mesh.triangles == this->Surface.mesh.triangles;
  this->Tally.degenerateRemoved += changes.removed;
  this->Tally.duplicatesRemoved += changes.repeats;
  this->Tally.cutsAdded +=
    surface.mesh.triangles.size() + changes.removed + changes.repeats - before;
  this->Tally.turned += changes.turned;
  this->Tally.edgesSplit += changes.edgesSplit;
  this->Tally.pointsSplit += changes.verticesSplit;
  this->Surface.become(std::move(surface));
  return !isSame;
}

bool Mender::moveSpikes()
{
  if (!this->isListed(DefectKind::spikes))
  {
    return false;
  }
  TriMesh& mesh = this->Surface.mesh;
  const double ratio = this->Options.defects.spikeRatio;
  const Incidence trianglesAt = trianglesAtPoints(mesh);
  std::vector<Index> moved;
  for (int pass = 0; pass < kSpikePasses; ++pass)
  {
    std::vector<Spike> spikes = findSpikes(mesh, trianglesAt, ratio, this->Run);
    std::ranges::stable_sort(spikes, std::greater(), &Spike::height);
    const std::size_t before = moved.size();
    for (const Spike& candidate : spikes)
    {
      const auto around = trianglesAt.of(candidate.point);
      const bool isActive =
        std::ranges::any_of(around, [&](Index t) { return this->Surface.isActive[t] != 0; });
      const auto spike = spikeAt(mesh, trianglesAt, candidate.point, ratio); // others have moved
      if (!isActive || !spike)
      {
        continue;
      }
      const Vec3 from = std::exchange(mesh.points[spike->point], spike->middle);
      if (this->Surface.shiftOf(spike->point) > this->Options.maxDeviation)
      {
        mesh.points[spike->point] = from;
        continue;
      }
      moved.push_back(spike->point);
    }
    if (moved.size() == before)
    {
      break;
    }
  }
  std::ranges::sort(moved);
  moved.erase(std::unique(moved.begin(), moved.end()), moved.end());
  this->Tally.spikesMoved += moved.size();
  return !moved.empty();
}

bool Mender::removeComponents()
{
  if (!this->isListed(DefectKind::smallComponents) || !std::isinf(this->Options.maxDeviation))
  {
    return false;
  }
  DefectOptions only = this->Options.defects;
  only.kinds = DefectKinds().set(static_cast<std::size_t>(DefectKind::smallComponents));
  DefectList small = findDefects(this->Surface.mesh, only, this->Run);
  keepChosen(small, this->Surface.isActive);
  std::vector<std::uint8_t> isGone(this->Surface.mesh.triangles.size(), 0);
  for (const Defect& piece : small.defects)
  {
    std::ranges::for_each(piece.triangles, [&](Index t) { isGone[t] = 1; });
    this->Tally.componentTriangles += piece.triangles.size();
  }
  this->Tally.componentsRemoved += small.defects.size();
  this->Surface.removeTriangles(isGone);
  return !small.defects.empty();
}

bool Mender::fillHoles()
{
  if (!this->isListed(DefectKind::smallHoles))
  {
    return false;
  }
  const Exchange filled = fillSmallHoles(
    this->Surface, this->Options.defects.smallHole, this->Options.maxDeviation, this->Run);
  this->Tally.holesFilled += filled.places;
  this->Tally.holeTriangles += filled.added;
  return filled.places > 0;
}

/// One round. @return whether something changed
bool Mender::repair()
{
  bool isChanged = this->closeTornSeams();
  isChanged = this->becomeConsistent() || isChanged;
  isChanged = this->moveSpikes() || isChanged;
  if (has(this->Options.defects.kinds, DefectKind::selfIntersections) &&
    (isChanged || this->isListed(DefectKind::selfIntersections)))
  {
    const IntersectionRepair repair =
      repairIntersections(this->Surface, this->Options.maxDeviation, this->Run);
    this->Tally.intersections += repair;
    isChanged = isChanged || repair.any();
  }
  isChanged = this->removeComponents() || isChanged;
  return this->fillHoles() || isChanged;
}

void Mender::measureMoves()
{
  for (Index p = 0; p < this->Surface.mesh.points.size(); ++p)
  {
    const double shift = this->Surface.shiftOf(p);
    this->Tally.pointsMoved += shift > 0.0 ? 1 : 0;
    this->Tally.largestMove = std::max(this->Tally.largestMove, shift);
  }
}

MendResult Mender::run()
{
  MendResult result;
  this->Listed = this->find();
  if (this->Options.at)
  {
    keepNearest(this->Listed, this->Input, *this->Options.at);
    std::ranges::fill(this->Surface.isActive, 0);
    this->Options.defects.kinds.reset();
    for (const Defect& defect : this->Listed.defects)
    {
      this->Options.defects.kinds.set(static_cast<std::size_t>(defect.kind));
      std::ranges::for_each(defect.triangles, [&](Index t) { this->Surface.isActive[t] = 1; });
    }
  }
  result.found = this->Listed;
  while (!this->Listed.defects.empty() && this->Tally.rounds < this->Options.rounds)
  {
    this->Run.step("mend", static_cast<std::size_t>(this->Tally.rounds),
      static_cast<std::size_t>(this->Options.rounds));
    const MendSurface before = this->Surface;
    const MendTally tally = this->Tally;
    DefectList listed = this->Listed;
    ++this->Tally.rounds;
    if (!this->repair())
    {
      break;
    }
    this->Listed = this->find();
    if (extentOf(this->Listed) >= extentOf(listed)) // it only wanders
    {
      this->Surface = before;
      this->Tally = tally;
      this->Listed = std::move(listed);
      break;
    }
  }
  if (!this->Listed.defects.empty() && this->becomeConsistent())
  {
    this->Listed = this->find();
  }
  this->measureMoves();
  result.left = std::move(this->Listed);
  result.edit = this->Surface.finish();
  result.tally = this->Tally;
  return result;
}

} // namespace

MendResult mend(const TriMesh& mesh, std::span<const std::uint8_t> inRegion,
  const MendOptions& options, Execution& execution)
{
  requireCorners(mesh);
  return Mender(mesh, inRegion, options, execution).run();
}

} // namespace scan
