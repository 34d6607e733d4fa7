// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/thicken.h"

#include "filters/base/error.h"
#include "filters/geometry/half_edges.h"
#include "filters/geometry/limited_move.h"
#include "filters/geometry/local_plane.h"
#include "filters/geometry/mesh_split.h"
#include "filters/geometry/offset_vectors.h"
#include "filters/geometry/used_points.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace scan
{
namespace
{

/// What becomes a solid: an oriented 2-manifold on points that its triangles use.
struct Patch
{
  TriMesh mesh;
  std::vector<Index> mate;           // per half-edge; kNone at a boundary
  std::vector<Index> pointOrigin;    // of the input
  std::vector<Index> triangleOrigin; // of the input
};

/// The part of a surface that comes from the triangles of the region.
Patch patchOf(
  ConsistentSurface surface, std::span<const std::uint8_t> inRegion, Execution& execution)
{
  Patch patch;
  TriMesh mesh{ std::move(surface.mesh.points), {} };
  for (std::size_t t = 0; t < surface.mesh.triangles.size(); ++t)
  {
    if (inRegion[surface.triangleOrigin[t]] != 0)
    {
      mesh.triangles.push_back(surface.mesh.triangles[t]);
      patch.triangleOrigin.push_back(surface.triangleOrigin[t]);
    }
  }
  const std::vector<Index> kept = dropUnusedPoints(mesh);
  SplitResult split = splitNonManifold(std::move(mesh), execution); // a part may touch itself
  for (const Index point : split.pointOrigin)
  {
    patch.pointOrigin.push_back(surface.pointOrigin[kept[point]]);
  }
  patch.mesh = std::move(split.mesh);
  patch.mate = std::move(split.mate);
  return patch;
}

/// The input without the triangles of the region and without the points that only these use.
SurfaceEdit restOf(const TriMesh& mesh, std::span<const std::uint8_t> inRegion)
{
  std::vector<std::uint8_t> uses(mesh.points.size(), 0); // 1: by the region, 2: by others
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    for (const Index point : mesh.triangles[t])
    {
      auto& use = uses[point];
      use = static_cast<std::uint8_t>(use | (inRegion[t] != 0 ? 1 : 2));
    }
  }
  SurfaceEdit rest;
  std::vector<Index> place(mesh.points.size());
  for (Index i = 0; i < place.size(); ++i)
  {
    if (uses[i] != 1)
    {
      place[i] = static_cast<Index>(rest.mesh.points.size());
      rest.mesh.points.push_back(mesh.points[i]);
      rest.pointOrigin.push_back(i);
    }
  }
  for (Index t = 0; t < mesh.triangles.size(); ++t)
  {
    if (inRegion[t] == 0)
    {
      const auto& [a, b, c] = mesh.triangles[t];
      rest.mesh.triangles.push_back({ place[a], place[b], place[c] });
      rest.triangleOrigin.push_back(t);
    }
  }
  return rest;
}

/// The two copies and the strip.
class Solid
{
public:
  Solid(const Patch& patch, const ThickenOptions& options, Execution& execution)
    : Part(patch)
    , Count(static_cast<Index>(patch.mesh.points.size()))
  {
    const std::vector<Vec3> offsets = offsetVectors(patch.mesh, execution);
    const double share = options.side == ThickenSide::both ? 0.5
      : options.side == ThickenSide::out                   ? 1.0
                                                           : 0.0;
    this->HeldBack.assign(this->Count, 0);
    this->addCopy(offsets, share * options.thickness, options.maxDeviation, execution);
    this->addCopy(offsets, (share - 1.0) * options.thickness, options.maxDeviation, execution);
    const auto& triangles = patch.mesh.triangles;
    this->Mesh.triangles = triangles;
    std::ranges::transform(triangles, std::back_inserter(this->Mesh.triangles),
      [&](const Triangle& triangle)
      {
        const auto& [a, b, c] = triangle;
        return Triangle{ this->opposite(a), this->opposite(c), this->opposite(b) };
      });
    this->addStrip();
  }

  const TriMesh& mesh() const { return this->Mesh; }
  Index strip() const
  {
    return static_cast<Index>(this->Mesh.triangles.size() - 2 * this->Part.mesh.triangles.size());
  }
  Index heldBack() const { return static_cast<Index>(std::ranges::count(this->HeldBack, 1)); }

  /// Of its triangles and points.
  Index originOfTriangle(std::size_t t) const
  {
    const std::size_t count = this->Part.triangleOrigin.size();
    return t < 2 * count ? this->Part.triangleOrigin[t % count] : kNone;
  }
  Index originOfPoint(std::size_t point) const
  {
    return this->Part.pointOrigin[point % this->Count];
  }

private:
  /// The copy on the back of a point of the copy in front.
  Index opposite(Index point) const { return this->Count + point; }

  void addCopy(
    const std::vector<Vec3>& offsets, double distance, double limit, Execution& execution)
  {
    const std::size_t first = this->Mesh.points.size();
    this->Mesh.points.resize(first + this->Count);
    execution.parallelFor(this->Count, 1 << 14,
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t i = begin; i < end; ++i)
        {
          const Vec3& from = this->Part.mesh.points[i];
          const Vec3 to = from + offsets[i] * distance;
          this->Mesh.points[first + i] = limitedMove(from, to, limit);
          if (this->Mesh.points[first + i] != to)
          {
            this->HeldBack[i] = 1;
          }
        }
      });
  }

  void addStrip()
  {
    for (Index half = 0; half < this->Part.mate.size(); ++half)
    {
      if (this->Part.mate[half] != kNone)
      {
        continue;
      }
      const Index from = originOf(this->Part.mesh, half);
      const Index to = originOf(this->Part.mesh, nextHalf(half));
      const auto squaredLength = [&](Index a, Index b)
      {
        const Vec3 d = this->Mesh.points[b] - this->Mesh.points[a];
        return dot(d, d);
      };
      const Index back = this->opposite(from);
      const Index backTo = this->opposite(to);
      auto& triangles = this->Mesh.triangles;
      if (squaredLength(to, back) <= squaredLength(from, backTo))
      {
        triangles.insert(triangles.end(), { { to, from, back }, { to, back, backTo } });
      }
      else
      {
        triangles.insert(triangles.end(), { { from, back, backTo }, { from, backTo, to } });
      }
    }
  }

  const Patch& Part;
  Index Count; // points of a copy
  TriMesh Mesh;
  std::vector<std::uint8_t> HeldBack; // per point of the patch
};

/// Appends the solid.
void append(const Solid& solid, SurfaceEdit& edit)
{
  const auto first = static_cast<Index>(edit.mesh.points.size());
  const TriMesh& mesh = solid.mesh();
  edit.mesh.points.insert(edit.mesh.points.end(), mesh.points.begin(), mesh.points.end());
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
  {
    edit.pointOrigin.push_back(solid.originOfPoint(i));
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    const auto& [a, b, c] = mesh.triangles[t];
    edit.mesh.triangles.push_back({ first + a, first + b, first + c });
    edit.triangleOrigin.push_back(solid.originOfTriangle(t));
  }
}

/// Of the solid, at the end of an edit.
SurfaceFolds foldsOf(
  const Solid& solid, const TriMesh& input, std::size_t triangles, Execution& execution)
{
  std::vector<Vec3> before(solid.mesh().points.size());
  for (std::size_t i = 0; i < before.size(); ++i)
  {
    before[i] = input.points[solid.originOfPoint(i)];
  }
  // strips have no area before; but for the turned copies what they face before does not matter
  SurfaceFolds folds = findFolds(solid.mesh(), before, execution);
  folds.isFolded.insert(
    folds.isFolded.begin(), triangles - solid.mesh().triangles.size(), std::uint8_t{ 0 });
  return folds;
}

} // namespace

ThickenResult thicken(const TriMesh& mesh, std::span<const std::uint8_t> inRegion,
  const ThickenOptions& options, Execution& execution)
{
  if (!(options.thickness > 0.0))
  {
    throw Error(ErrorCode::badParameter, "thicken: the thickness must be more than 0");
  }
  requireCorners(mesh);
  execution.step("thicken", 0, 3);
  ConsistentSurface surface = makeConsistent(mesh, 0.0, execution);
  ThickenResult result;
  const SurfaceChanges changes = surface.changes;
  execution.step("thicken", 1, 3);
  const Patch patch = patchOf(std::move(surface), inRegion, execution);
  if (patch.mesh.triangles.empty())
  {
    result.edit = unchanged(mesh);
    result.folds.isFolded.assign(mesh.triangles.size(), 0);
    return result;
  }
  result.changes = changes;
  const Solid solid(patch, options, execution);
  execution.step("thicken", 2, 3);
  result.strip = solid.strip();
  result.heldBack = solid.heldBack();
  result.edit = restOf(mesh, inRegion);
  append(solid, result.edit);
  execution.step("thicken", 3, 3);
  execution.step("folds", 0, 1);
  result.folds = foldsOf(solid, mesh, result.edit.mesh.triangles.size(), execution);
  execution.step("folds", 1, 1);
  return result;
}

} // namespace scan
