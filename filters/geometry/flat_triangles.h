// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/mesh.h"

#include <vector>

namespace scan
{

/// Whether three points lie on a line, equal ones too. Exact for coordinates up to 1e50; false for
/// what is not finite.
bool isFlat(const Vec3& a, const Vec3& b, const Vec3& c);

/// A mesh whose triangles all have area.
struct FlatRemoval
{
  TriMesh mesh;
  std::vector<Index> triangleOrigin; ///< per triangle: the input triangle that it is a part of
  Index cut = 0;                     ///< input triangles of which there are several parts
};

/// Takes out the triangles without area, those that name a point twice too, and leaves no gap where
/// they were: neighbours along an edge of such triangles are cut at the other corners that lie on
/// it, and corners in one place become one point; two triangles that thereby come to lie upon each
/// other and face opposite sides go. A closed surface stays closed. Triangles keep their order,
/// parts of one follow each other; points stay, also those that no triangle uses any more. A mesh
/// without such triangles is returned as it is.
///
/// Time n log n for n triangles. Throws Cancelled.
/// @param mesh its triangles name points that are there
/// @param leastHeight 0: exact, only what lies on a line has no area, and nothing moves; more: so
///   does what is not higher than that, and corners move that far, or where cuts would undo each
///   other by the length of the shortest edge of such a triangle
FlatRemoval removeFlatTriangles(TriMesh mesh, double leastHeight, Execution& execution);

} // namespace scan
