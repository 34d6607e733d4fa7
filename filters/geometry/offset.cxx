// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/offset.h"

#include "filters/geometry/consistent_surface.h"
#include "filters/geometry/limited_move.h"
#include "filters/geometry/offset_vectors.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace scan
{
namespace
{

/// The triangles as they should face, on the same points.
TriMesh consistentSides(const TriMesh& mesh, Execution& execution)
{
  ConsistentSurface surface = makeConsistent(mesh, 0.0, execution);
  for (Triangle& triangle : surface.mesh.triangles)
  {
    std::ranges::for_each(triangle, [&](Index& point) { point = surface.pointOrigin[point]; });
  }
  return { mesh.points, std::move(surface.mesh.triangles) };
}

} // namespace

OffsetResult offset(const TriMesh& mesh, std::span<const std::uint8_t> inRegion,
  const OffsetOptions& options, Execution& execution)
{
  execution.step("offset", 0, 2);
  const TriMesh sides = consistentSides(mesh, execution);
  execution.step("offset", 1, 2);
  const std::vector<Vec3> offsets = offsetVectors(sides, execution);
  OffsetResult result;
  result.edit = unchanged(mesh);
  for (std::size_t i = 0; i < offsets.size(); ++i)
  {
    if (inRegion[i] != 0)
    {
      const Vec3 to = mesh.points[i] + offsets[i] * options.distance;
      Vec3& point = result.edit.mesh.points[i];
      point = limitedMove(mesh.points[i], to, options.maxDeviation);
      result.heldBack += point != to ? 1 : 0;
      result.moved += point != mesh.points[i] ? 1 : 0;
    }
  }
  execution.step("offset", 2, 2);
  execution.step("folds", 0, 1);
  result.folds = findFolds(result.edit.mesh, mesh.points, execution);
  execution.step("folds", 1, 1);
  return result;
}

} // namespace scan
