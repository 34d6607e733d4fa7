// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/mesh.h"
#include "filters/geometry/surface_edit.h"

#include <cstdint>
#include <span>

namespace scan
{

/// A mesh with others in place of some of its triangles. First comes what stays, in its order, then
/// what is new; points of replaced triangles go unless they are used. The origins of the new
/// triangles and the blends are left to the caller.
/// @param isReplaced per triangle 0 or 1
/// @param made the other triangles, on points that are all used
/// @param origins per point of `made`: the point of the mesh that it is; kNone for a new one
SurfaceEdit replaceTriangles(const TriMesh& mesh, std::span<const std::uint8_t> isReplaced,
  const TriMesh& made, std::span<const Index> origins);

} // namespace scan
