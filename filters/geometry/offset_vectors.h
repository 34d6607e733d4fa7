// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/mesh.h"

#include <vector>

namespace scan
{

/// Longest vector of offsetVectors(). The corner of a cube needs 1.74.
inline constexpr double kLongestOffset = 2.0;

/// Per point the vector along which it moves so that the planes of its triangles move by 1, to the
/// side that they face: d with n . d = 1 for the normals n of all its triangles, as exactly as
/// possible by least squares, each weighted by its angle at the point. Where these leave a
/// direction open, as in a plane or along an edge, and nearly so where the surface is smooth, d is
/// along the mean normal. So a plate between
/// two offsets has the same thickness everywhere, at edges and corners, too; but no vector is
/// longer than kLongestOffset, which edges sharper than 60 degrees would need.
///
/// (0, 0, 0) for points without triangles that have area. Linear time.
/// Triangles name points that are there, and should agree about the sides.
std::vector<Vec3> offsetVectors(const TriMesh& mesh, Execution& execution);

} // namespace scan
