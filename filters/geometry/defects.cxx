// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/defects.h"

#include "filters/base/error.h"
#include "filters/geometry/consistent_surface.h"
#include "filters/geometry/flat_triangles.h"
#include "filters/geometry/half_edges.h"
#include "filters/geometry/holes.h"
#include "filters/geometry/incidence.h"
#include "filters/geometry/local_plane.h"
#include "filters/geometry/seams.h"
#include "filters/geometry/self_intersections.h"
#include "filters/geometry/shells.h"
#include "filters/geometry/spikes.h"
#include "filters/geometry/triangle_measures.h"
#include "filters/geometry/union_find.h"

#include <algorithm>
#include <map>
#include <set>
#include <span>
#include <string>
#include <utility>

namespace scan
{
namespace
{

class DefectSearch
{
public:
  DefectSearch(const TriMesh& mesh, const DefectOptions& options, Execution& execution)
    : Mesh(mesh)
    , Options(options)
    , Run(execution)
    , Pairs(pairEdges(mesh, execution))
  {
  }

  DefectList run();

private:
  void add(DefectKind kind, const Vec3& place, std::vector<Index> triangles);
  void addGroups(DefectKind kind, const std::vector<Index>& triangles,
    std::span<const std::array<Index, 2>> ties);
  void findCrowdedEdges();
  void findPinchedPoints();
  void findIntersections();
  void findDegenerate();
  void findDuplicates();
  void findInverted();
  void findSpikesOf();
  void findSmallComponents();
  void findSmallHoles();
  void findSeamsOf();

  const TriMesh& Mesh;
  const DefectOptions& Options;
  Execution& Run;
  EdgePairs Pairs;
  DefectList List;
};

void DefectSearch::add(DefectKind kind, const Vec3& place, std::vector<Index> triangles)
{
  std::ranges::sort(triangles);
  triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
  this->List.defects.push_back({ kind, place, std::move(triangles) });
}

/// Adds triangles as one defect each for those that hang together: by a common point or by a tie.
void DefectSearch::addGroups(
  DefectKind kind, const std::vector<Index>& triangles, std::span<const std::array<Index, 2>> ties)
{
  std::map<Index, Index> slot; // of a triangle in `triangles`
  std::map<Index, Index> slotAtPoint;
  UnionFind groups(triangles.size());
  for (Index i = 0; i < triangles.size(); ++i)
  {
    slot.emplace(triangles[i], i);
    for (const Index point : this->Mesh.triangles[triangles[i]])
    {
      groups.unite(i, slotAtPoint.emplace(point, i).first->second);
    }
  }
  for (const auto& [a, b] : ties)
  {
    groups.unite(slot.at(a), slot.at(b));
  }
  std::map<Index, std::vector<Index>> members;
  for (Index i = 0; i < triangles.size(); ++i)
  {
    members[groups.root(i)].push_back(triangles[i]);
  }
  for (auto& [root, group] : members)
  {
    const Vec3 place = middleOf(this->Mesh.points, this->Mesh.triangles[group.front()]);
    this->add(kind, place, std::move(group));
  }
}

void DefectSearch::findCrowdedEdges()
{
  for (std::size_t i = 1; i < this->Pairs.crowdedBegin.size(); ++i)
  {
    std::vector<Index> around;
    for (Index k = this->Pairs.crowdedBegin[i - 1]; k < this->Pairs.crowdedBegin[i]; ++k)
    {
      around.push_back(this->Pairs.crowded[k] / 3);
    }
    const Index half = this->Pairs.crowded[this->Pairs.crowdedBegin[i - 1]];
    const Vec3 middle = (this->Mesh.points[originOf(this->Mesh, half)] +
                          this->Mesh.points[originOf(this->Mesh, nextHalf(half))]) *
      0.5;
    this->add(DefectKind::nonManifoldEdges, middle, std::move(around));
  }
}

void DefectSearch::findPinchedPoints()
{
  // corners of triangles at a point are one fan where edges join them
  const TriMesh& mesh = this->Mesh;
  UnionFind fans(3 * mesh.triangles.size());
  const auto cornerAt = [&](Index half, Index point)
  { return originOf(mesh, half) == point ? half : nextHalf(half); };
  for (Index half = 0; half < this->Pairs.mate.size(); ++half)
  {
    const Index mate = this->Pairs.mate[half];
    if (mate != kNone && half < mate)
    {
      for (const Index point : { originOf(mesh, half), originOf(mesh, nextHalf(half)) })
      {
        fans.unite(cornerAt(half, point), cornerAt(mate, point));
      }
    }
  }
  std::vector<std::uint8_t> isLeftOut(mesh.points.size(), 0);
  for (const Index half : this->Pairs.crowded)
  {
    isLeftOut[originOf(mesh, half)] = isLeftOut[originOf(mesh, nextHalf(half))] = 1;
  }
  std::vector<Index> fanOf(mesh.points.size(), kNone);
  std::set<Index> pinched;
  for (Index corner = 0; corner < 3 * mesh.triangles.size(); ++corner)
  {
    const Index point = originOf(mesh, corner);
    if (isLeftOut[point] != 0 || isCollapsed(mesh.triangles[corner / 3]))
    {
      continue;
    }
    const Index fan = fans.root(corner);
    if (fanOf[point] == kNone)
    {
      fanOf[point] = fan;
    }
    else if (fanOf[point] != fan)
    {
      pinched.insert(point);
    }
  }
  if (pinched.empty())
  {
    return;
  }
  const Incidence trianglesAt = trianglesAtPoints(mesh);
  for (const Index point : pinched)
  {
    const auto around = trianglesAt.of(point);
    this->add(DefectKind::nonManifoldPoints, mesh.points[point], { around.begin(), around.end() });
  }
}

void DefectSearch::findIntersections()
{
  const std::vector<TrianglePair> pairs = selfIntersections(this->Mesh, this->Run);
  std::vector<Index> triangles;
  for (const auto& [a, b] : pairs)
  {
    triangles.insert(triangles.end(), { a, b });
  }
  std::ranges::sort(triangles);
  triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
  this->addGroups(DefectKind::selfIntersections, triangles, pairs);
}

void DefectSearch::findDegenerate()
{
  const double least = this->Options.leastHeight;
  std::vector<std::uint8_t> isBad(this->Mesh.triangles.size(), 0);
  this->Run.parallelFor(isBad.size(), 4096,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t t = begin; t < end; ++t)
      {
        const auto& [a, b, c] = this->Mesh.triangles[t];
        const std::vector<Vec3>& at = this->Mesh.points;
        const Vec3 normal = cross(at[b] - at[a], at[c] - at[a]);
        const double longest = std::max({ dot(at[b] - at[a], at[b] - at[a]),
          dot(at[c] - at[b], at[c] - at[b]), dot(at[a] - at[c], at[a] - at[c]) });
        isBad[t] = isCollapsed({ a, b, c }) || isFlat(at[a], at[b], at[c]) ||
            (least > 0.0 && dot(normal, normal) <= least * least * longest)
          ? 1
          : 0;
      }
    });
  for (Index t = 0; t < isBad.size(); ++t)
  {
    if (isBad[t] != 0)
    {
      this->add(
        DefectKind::degenerate, middleOf(this->Mesh.points, this->Mesh.triangles[t]), { t });
    }
  }
}

void DefectSearch::findDuplicates()
{
  std::vector<std::pair<Triangle, Index>> known;
  for (const Index t : candidatesForRepeats(this->Pairs))
  {
    Triangle corners = this->Mesh.triangles[t];
    std::ranges::sort(corners);
    known.emplace_back(corners, t);
  }
  std::ranges::sort(known);
  for (std::size_t i = 0; i < known.size();)
  {
    std::vector<Index> others;
    std::size_t k = i + 1;
    for (; k < known.size() && known[k].first == known[i].first; ++k)
    {
      others.push_back(known[k].second);
    }
    if (!others.empty())
    {
      this->add(
        DefectKind::duplicates, middleOf(this->Mesh.points, known[i].first), std::move(others));
    }
    i = k;
  }
}

void DefectSearch::findInverted()
{
  const Shells shells = findShells(this->Mesh, this->Pairs.mate);
  if (this->Pairs.misoriented.empty() &&
    std::ranges::none_of(shells.shells, [](const Shell& shell) { return shell.volume < 0.0; }))
  {
    return;
  }
  const ConsistentSurface surface =
    makeConsistent(this->Mesh, { .repeats = false, .flat = false, .split = false }, this->Run);
  std::vector<Index> wrong;
  for (Index t = 0; t < this->Mesh.triangles.size(); ++t)
  {
    if (surface.isTurned[t])
    {
      wrong.push_back(t);
    }
  }
  for (const Index half : this->Pairs.misoriented)
  {
    const Index t = half / 3;
    const Index other = this->Pairs.mate[half] / 3;
    if (surface.isTurned[t] == surface.isTurned[other]) // one side only
    {
      wrong.insert(wrong.end(), { t, other });
    }
  }
  std::ranges::sort(wrong);
  wrong.erase(std::unique(wrong.begin(), wrong.end()), wrong.end());
  this->addGroups(DefectKind::inverted, wrong, {});
}

void DefectSearch::findSpikesOf()
{
  const Incidence trianglesAt = trianglesAtPoints(this->Mesh);
  for (const Spike& spike :
    findSpikes(this->Mesh, trianglesAt, this->Options.spikeRatio, this->Run))
  {
    const auto around = trianglesAt.of(spike.point);
    this->add(DefectKind::spikes, this->Mesh.points[spike.point], { around.begin(), around.end() });
  }
}

void DefectSearch::findSmallComponents()
{
  UnionFind pieces(this->Mesh.triangles.size());
  for (Index half = 0; half < this->Pairs.mate.size(); ++half)
  {
    if (this->Pairs.mate[half] != kNone)
    {
      pieces.unite(half / 3, this->Pairs.mate[half] / 3);
    }
  }
  for (std::size_t i = 1; i < this->Pairs.crowdedBegin.size(); ++i)
  {
    const Index first = this->Pairs.crowded[this->Pairs.crowdedBegin[i - 1]];
    for (Index k = this->Pairs.crowdedBegin[i - 1]; k < this->Pairs.crowdedBegin[i]; ++k)
    {
      pieces.unite(first / 3, this->Pairs.crowded[k] / 3);
    }
  }
  std::vector<Index> triangles(this->Mesh.triangles.size(), 0);
  std::vector<double> area(this->Mesh.triangles.size(), 0.0);
  for (Index t = 0; t < triangles.size(); ++t)
  {
    if (!isCollapsed(this->Mesh.triangles[t]))
    {
      ++triangles[pieces.root(t)];
      area[pieces.root(t)] += areaOf(this->Mesh.points, this->Mesh.triangles[t]);
    }
  }
  const double mostTriangles = this->Options.smallComponent * *std::ranges::max_element(triangles);
  const double mostArea = this->Options.smallComponent * *std::ranges::max_element(area);
  std::map<Index, std::vector<Index>> small;
  for (Index t = 0; t < triangles.size(); ++t)
  {
    const Index root = pieces.root(t);
    if (triangles[root] > 0 && triangles[root] < mostTriangles && area[root] < mostArea)
    {
      small[root].push_back(t);
    }
  }
  for (auto& [root, members] : small)
  {
    this->add(DefectKind::smallComponents, middleOf(this->Mesh.points, this->Mesh.triangles[root]),
      std::move(members));
  }
}

void DefectSearch::findSmallHoles()
{
  if (this->Pairs.boundaryEdges == 0)
  {
    return;
  }
  for (const BoundaryLoop& loop : boundaryLoops(this->Mesh, this->Run))
  {
    if (loop.isManifold && loop.length <= this->Options.smallHole && !isOuterRim(loop))
    {
      std::vector<Index> along;
      for (const Index half : loop.halves)
      {
        along.push_back(half / 3);
      }
      this->add(DefectKind::smallHoles, loop.place, std::move(along));
    }
  }
}

void DefectSearch::findSeamsOf()
{
  std::vector<Index> along;
  const std::vector<SeamEdge> seams = findSeams(this->Mesh, this->Pairs);
  std::vector<std::array<Index, 2>> ties;
  for (const auto& [a, b] : seams)
  {
    along.insert(along.end(), { a / 3, b / 3 });
    ties.push_back({ a / 3, b / 3 });
  }
  std::ranges::sort(along);
  along.erase(std::unique(along.begin(), along.end()), along.end());
  this->addGroups(DefectKind::seams, along, ties);
}

DefectList DefectSearch::run()
{
  if (this->Mesh.triangles.empty())
  {
    return {};
  }
  using Find = void (DefectSearch::*)();
  constexpr std::array<Find, kDefectKinds> kFinds{ &DefectSearch::findCrowdedEdges,
    &DefectSearch::findPinchedPoints, &DefectSearch::findIntersections,
    &DefectSearch::findDegenerate, &DefectSearch::findDuplicates, &DefectSearch::findInverted,
    &DefectSearch::findSpikesOf, &DefectSearch::findSmallComponents, &DefectSearch::findSmallHoles,
    &DefectSearch::findSeamsOf };
  for (std::size_t kind = 0; kind < kDefectKinds; ++kind)
  {
    this->Run.step("find defects", kind, kDefectKinds);
    if (this->Options.kinds[kind])
    {
      (this->*kFinds[kind])();
    }
  }
  std::ranges::stable_sort(this->List.defects,
    [](const Defect& a, const Defect& b)
    { return std::pair(a.kind, a.triangles.front()) < std::pair(b.kind, b.triangles.front()); });
  return std::move(this->List);
}

} // namespace

DefectKinds parseDefectKinds(std::string_view text)
{
  if (text == "all")
  {
    return DefectKinds().set();
  }
  DefectKinds kinds;
  while (true)
  {
    const std::size_t comma = text.find(',');
    const std::string_view name = text.substr(0, comma);
    const auto found = std::ranges::find(kDefectNames, name);
    if (found == kDefectNames.end())
    {
      std::string known = "all";
      for (const std::string_view other : kDefectNames)
      {
        known.append(", ").append(other);
      }
      throw Error(ErrorCode::badParameter,
        std::string("fix: '")
          .append(name)
          .append("' is no kind of defect; these are: ")
          .append(known));
    }
    kinds.set(static_cast<std::size_t>(found - kDefectNames.begin()));
    if (comma == std::string_view::npos)
    {
      return kinds;
    }
    text.remove_prefix(comma + 1);
  }
}

std::size_t DefectList::count(DefectKind kind) const
{
  return static_cast<std::size_t>(
    std::ranges::count(this->defects, kind, [](const Defect& defect) { return defect.kind; }));
}

std::size_t DefectList::triangles(DefectKind kind) const
{
  std::vector<Index> all;
  for (const Defect& defect : this->defects)
  {
    if (defect.kind == kind)
    {
      all.insert(all.end(), defect.triangles.begin(), defect.triangles.end());
    }
  }
  std::ranges::sort(all);
  return static_cast<std::size_t>(std::unique(all.begin(), all.end()) - all.begin());
}

DefectList findDefects(const TriMesh& mesh, const DefectOptions& options, Execution& execution)
{
  requireCorners(mesh);
  return DefectSearch(mesh, options, execution).run();
}

} // namespace scan
