// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/patch_refill.h"

#include "filters/geometry/half_edges.h"
#include "filters/geometry/holes.h"
#include "filters/geometry/local_plane.h"
#include "filters/geometry/loop_triangulation.h"
#include "filters/geometry/point_triangle.h"
#include "filters/geometry/self_intersections.h"
#include "filters/geometry/shells.h"
#include "filters/geometry/spikes.h"
#include "filters/geometry/triangle_measures.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

namespace scan
{
namespace
{

constexpr std::size_t kMostTriangles = 4000; // in a patch
constexpr std::size_t kMostCorners = 300;    // of a rim

class Refill
{
public:
  Refill(MendSurface& surface, double maxDeviation, Execution& execution)
    : Surface(surface)
    , Mesh(surface.mesh)
    , MaxDeviation(maxDeviation)
    , Run(execution)
    , Mate(pairEdges(surface.mesh, execution).mate)
    , Pieces(findShells(surface.mesh, this->Mate))
    , TrianglesAt(trianglesAtPoints(surface.mesh))
    , IsGone(surface.mesh.triangles.size(), 0)
  {
  }

  Exchange run(const std::vector<std::uint8_t>& inRegion);
  Exchange fillHoles(double longest);

private:
  std::vector<std::vector<Index>> patches(const std::vector<std::uint8_t>& inRegion) const;
  void refill(const std::vector<Index>& patch);
  Exchange addFillings(const std::vector<std::vector<Triangle>>& fillings);
  EdgeSet takenAt(const std::vector<Index>& points, const std::vector<Index>& patch) const;
  std::optional<std::vector<Triangle>> span(
    const SpaceLoop& rim, const std::vector<Index>& patch, EdgeSet& taken);
  bool isNearRim(const SpaceLoop& rim, const std::vector<Triangle>& filled) const;
  bool isWithin(const std::vector<Index>& patch, const std::vector<Triangle>& filled) const;
  bool isThere(const Triangle& triangle, const std::vector<Index>& patch) const;

  MendSurface& Surface;
  const TriMesh& Mesh;
  double MaxDeviation;
  Execution& Run;
  std::vector<Index> Mate;
  Shells Pieces;
  Incidence TrianglesAt;
  std::vector<std::uint8_t> IsGone;
  std::vector<Triangle> New;
  std::size_t Places = 0;
};

std::vector<std::vector<Index>> Refill::patches(const std::vector<std::uint8_t>& inRegion) const
{
  std::vector<std::vector<Index>> patches;
  std::vector<std::uint8_t> isSeen(inRegion.size(), 0);
  for (Index first = 0; first < inRegion.size(); ++first)
  {
    if (inRegion[first] == 0 || isSeen[first] != 0)
    {
      continue;
    }
    isSeen[first] = 1;
    std::vector<Index> patch{ first };
    for (std::size_t i = 0; i < patch.size(); ++i)
    {
      for (Index half = 3 * patch[i]; half < 3 * patch[i] + 3; ++half)
      {
        const Index other = this->Mate[half] == kNone ? first : this->Mate[half] / 3;
        if (inRegion[other] != 0 && isSeen[other] == 0)
        {
          isSeen[other] = 1;
          patch.push_back(other);
        }
      }
    }
    std::ranges::sort(patch);
    patches.push_back(std::move(patch));
  }
  return patches;
}

bool Refill::isThere(const Triangle& triangle, const std::vector<Index>& patch) const
{
  Triangle sorted = triangle;
  std::ranges::sort(sorted);
  return std::ranges::any_of(this->TrianglesAt.of(triangle[0]),
    [&](Index t)
    {
      Triangle other = this->Mesh.triangles[t];
      std::ranges::sort(other);
      return other == sorted && !std::ranges::binary_search(patch, t);
    });
}

/// The edges that a filling must not use: those of the triangles that stay, and new ones.
EdgeSet Refill::takenAt(const std::vector<Index>& points, const std::vector<Index>& patch) const
{
  EdgeSet taken;
  const auto take = [&](const Triangle& t)
  {
    taken.add(t[0], t[1]);
    taken.add(t[1], t[2]);
    taken.add(t[2], t[0]);
  };
  for (const Index point : points)
  {
    for (const Index t : this->TrianglesAt.of(point))
    {
      if (!std::ranges::binary_search(patch, t))
      {
        take(this->Mesh.triangles[t]);
      }
    }
  }
  std::ranges::for_each(this->New, take);
  return taken;
}

/// The triangles that span a rim; none where that cannot be.
/// @param patch the triangles that go, rising
std::optional<std::vector<Triangle>> Refill::span(
  const SpaceLoop& rim, const std::vector<Index>& patch, EdgeSet& taken)
{
  auto filled = triangulateLoop(rim, LoopAim::fold, taken, this->Run);
  if (!filled)
  {
    return std::nullopt;
  }
  for (Triangle& t : *filled)
  {
    std::ranges::for_each(t, [&](Index& corner) { corner = rim.names[corner]; });
    if (this->isThere(t, patch))
    {
      return std::nullopt;
    }
  }
  for (const auto& [a, b, c] : *filled)
  {
    taken.add(a, b);
    taken.add(b, c);
    taken.add(c, a);
  }
  return filled;
}

/// Whether points of both surfaces are near enough to the other.
bool Refill::isWithin(const std::vector<Index>& patch, const std::vector<Triangle>& filled) const
{
  if (std::isinf(this->MaxDeviation))
  {
    return true;
  }
  std::vector<Triangle> old;
  for (const Index t : patch)
  {
    old.push_back(this->Mesh.triangles[t]);
  }
  const auto isNear = [&](const Vec3& p, const std::vector<Triangle>& to)
  {
    return std::ranges::any_of(to,
      [&](const Triangle& t)
      {
        return squaredDistance(p, this->Mesh.points[t[0]], this->Mesh.points[t[1]],
                 this->Mesh.points[t[2]]) <= this->MaxDeviation * this->MaxDeviation;
      });
  };
  const auto areNear = [&](const std::vector<Triangle>& from, const std::vector<Triangle>& to)
  {
    return std::ranges::all_of(from,
      [&](const Triangle& t)
      {
        const Vec3& a = this->Mesh.points[t[0]];
        const Vec3& b = this->Mesh.points[t[1]];
        const Vec3& c = this->Mesh.points[t[2]];
        return isNear(a, to) && isNear(b, to) && isNear(c, to) &&
          isNear((a + b + c) * (1.0 / 3.0), to) && isNear((a + b) * 0.5, to) &&
          isNear((b + c) * 0.5, to) && isNear((c + a) * 0.5, to);
      });
  };
  return areNear(old, filled) && areNear(filled, old);
}

void Refill::refill(const std::vector<Index>& patch)
{
  const Shell& piece = this->Pieces.shells[this->Pieces.shellOf[patch.front()]];
  if (patch.size() > kMostTriangles || 2 * patch.size() > piece.triangles)
  {
    return;
  }
  TriMesh part; // with points of its own numbers
  std::map<Index, Index> number;
  std::vector<Index> names;
  for (const Index t : patch)
  {
    Triangle corners = this->Mesh.triangles[t];
    for (Index& corner : corners)
    {
      const auto [at, isNew] = number.emplace(corner, static_cast<Index>(names.size()));
      if (isNew)
      {
        names.push_back(corner);
        part.points.push_back(this->Mesh.points[corner]);
      }
      corner = at->second;
    }
    part.triangles.push_back(corners);
  }
  const std::vector<BoundaryLoop> loops = boundaryLoops(part, this->Run);
  EdgeSet taken = this->takenAt(names, patch);
  std::vector<Triangle> filled;
  for (const BoundaryLoop& loop : loops)
  {
    if (!loop.isManifold || loop.points.size() > kMostCorners)
    {
      return;
    }
    SpaceLoop rim;
    for (std::size_t i = 0; i < loop.points.size(); ++i)
    {
      const Index half = loop.halves[i];
      const Index mate = this->Mate[3 * patch[half / 3] + half % 3];
      rim.names.push_back(names[loop.points[i]]);
      rim.corners.push_back(part.points[loop.points[i]]);
      rim.normals.push_back(
        mate == kNone ? Vec3{} : normalOf(this->Mesh.points, this->Mesh.triangles[mate / 3]));
    }
    const auto triangles = this->span(rim, patch, taken);
    if (!triangles)
    {
      return;
    }
    filled.insert(filled.end(), triangles->begin(), triangles->end());
  }
  if (loops.empty() || !this->isWithin(patch, filled))
  {
    return;
  }
  for (const Index t : patch)
  {
    this->IsGone[t] = 1;
  }
  this->New.insert(this->New.end(), filled.begin(), filled.end());
  ++this->Places;
}

/// Whether new triangles stay near a rim, by their middles and those of their sides.
bool Refill::isNearRim(const SpaceLoop& rim, const std::vector<Triangle>& filled) const
{
  const auto isNear = [&](const Vec3& p)
  {
    return std::ranges::any_of(
      rim.corners, [&](const Vec3& q) { return length(p - q) <= this->MaxDeviation; });
  };
  return std::isinf(this->MaxDeviation) ||
    std::ranges::all_of(filled,
      [&](const Triangle& t)
      {
        const Vec3& a = this->Mesh.points[t[0]];
        const Vec3& b = this->Mesh.points[t[1]];
        const Vec3& c = this->Mesh.points[t[2]];
        return isNear((a + b + c) * (1.0 / 3.0)) && isNear((a + b) * 0.5) &&
          isNear((b + c) * 0.5) && isNear((c + a) * 0.5);
      });
}

Exchange Refill::fillHoles(double longest)
{
  std::vector<std::vector<Triangle>> fillings;
  for (const BoundaryLoop& loop : boundaryLoops(this->Mesh, this->Run))
  {
    const bool isActive = std::ranges::any_of(
      loop.halves, [&](Index half) { return this->Surface.isActive[half / 3] != 0; });
    if (!isActive || !loop.isManifold || loop.length > longest || isOuterRim(loop) ||
      loop.points.size() > kMostCorners)
    {
      continue;
    }
    SpaceLoop rim; // the other way round
    for (std::size_t i = loop.points.size(); i-- > 0;)
    {
      const std::size_t behind = i == 0 ? loop.points.size() - 1 : i - 1;
      rim.names.push_back(loop.points[i]);
      rim.corners.push_back(this->Mesh.points[loop.points[i]]);
      rim.normals.push_back(
        normalOf(this->Mesh.points, this->Mesh.triangles[loop.halves[behind] / 3]));
    }
    EdgeSet taken = this->takenAt(rim.names, {});
    auto filled = this->span(rim, {}, taken);
    if (filled && this->isNearRim(rim, *filled))
    {
      this->New.insert(this->New.end(), filled->begin(), filled->end());
      fillings.push_back(std::move(*filled));
    }
  }
  return this->addFillings(fillings);
}

/// Adds those that intersect nothing.
Exchange Refill::addFillings(const std::vector<std::vector<Triangle>>& fillings)
{
  const auto before = static_cast<Index>(this->Mesh.triangles.size());
  std::vector<Index> fillingOf;
  for (Index i = 0; i < fillings.size(); ++i)
  {
    for (const Triangle& t : fillings[i])
    {
      this->Surface.addTriangle(t, kNone);
      fillingOf.push_back(i);
    }
  }
  std::vector<bool> isBad(fillings.size());
  if (!fillings.empty())
  {
    std::vector<Index> added(fillingOf.size());
    std::iota(added.begin(), added.end(), before);
    for (const auto& [a, b] : selfIntersections(this->Mesh, added, this->Run))
    {
      for (const Index t : { a, b })
      {
        if (t >= before)
        {
          isBad[fillingOf[t - before]] = true;
        }
      }
    }
  }
  Exchange exchange;
  std::vector<std::uint8_t> isGone(this->Mesh.triangles.size(), 0);
  for (std::size_t i = 0; i < fillingOf.size(); ++i)
  {
    isGone[before + i] = isBad[fillingOf[i]] ? 1 : 0;
    exchange.added += isBad[fillingOf[i]] ? 0 : 1;
  }
  exchange.places = static_cast<std::size_t>(std::ranges::count(isBad, false));
  this->Surface.removeTriangles(isGone);
  return exchange;
}

Exchange Refill::run(const std::vector<std::uint8_t>& inRegion)
{
  for (const std::vector<Index>& patch : this->patches(inRegion))
  {
    this->refill(patch);
  }
  const Exchange exchange{ static_cast<std::size_t>(std::ranges::count(this->IsGone, 1)),
    this->New.size(), this->Places };
  this->Surface.removeTriangles(this->IsGone);
  for (const Triangle& t : this->New)
  {
    this->Surface.addTriangle(t, kNone);
  }
  return exchange;
}

} // namespace

Exchange refillPatches(MendSurface& surface, const std::vector<std::uint8_t>& inRegion,
  double maxDeviation, Execution& execution)
{
  return Refill(surface, maxDeviation, execution).run(inRegion);
}

Exchange fillSmallHoles(
  MendSurface& surface, double longest, double maxDeviation, Execution& execution)
{
  return Refill(surface, maxDeviation, execution).fillHoles(longest);
}

} // namespace scan
