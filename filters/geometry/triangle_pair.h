// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/mesh.h"

namespace scan
{

/// A plane through a triangle.
struct TrianglePlane
{
  Vec3 corner; ///< the first of the triangle
  Vec3 normal;
  Vec3 extent; ///< of the triangle, from the corner

  TrianglePlane() = default;
  TrianglePlane(const TriMesh& mesh, Index triangle);
};

/// Exactly: do two triangles meet in more than the corners or the edge that they share by number?
/// Neither is flat.
/// @param plane of the first
bool meetBeyondShared(const TriMesh& mesh, Index first, const TrianglePlane& plane, Index second);

} // namespace scan
