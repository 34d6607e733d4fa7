// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/mesh.h"

#include <cstdint>
#include <span>
#include <vector>

namespace scan
{

/// Where a surface whose points have moved folds onto itself.
struct SurfaceFolds
{
  std::vector<std::uint8_t> isFolded; ///< per triangle 1 for those of any kind below
  Index turned = 0;                   ///< triangles that face against what they faced before
  Index shrunk = 0;         ///< not turned, but with less than a thousandth of their area left
  Index crossing = 0;       ///< in more than common corners and edges with others
  Index folded = 0;         ///< of any kind
  std::vector<Vec3> places; ///< of folded triangles that hang together, one on each: most first
};

/// Compares a mesh with where its points were before. Triangles that had no area then are asked
/// for crossings only, and those that cross without a corner of both having moved do not count.
/// Collapsed triangles never do.
/// Throws Error badInput as selfIntersections(); Cancelled.
/// @param before as many as the mesh has points
SurfaceFolds findFolds(const TriMesh& mesh, std::span<const Vec3> before, Execution& execution);

} // namespace scan
