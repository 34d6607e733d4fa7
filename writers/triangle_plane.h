// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/mesh.h"

#include <optional>

namespace scan
{

/// The plane of a triangle, as exact as doubles hold it however thin the triangle is and however
/// far from the origin.
struct TrianglePlane
{
  Vec3 normal;         ///< of length 1, to the side from which the corners turn counter-clockwise
  Vec3 along;          ///< of length 1, from the first to the second corner
  double offset = 0.0; ///< of the plane from the origin, along the normal
};

/// None for a triangle without area.
std::optional<TrianglePlane> planeOf(const Vec3& a, const Vec3& b, const Vec3& c);

} // namespace scan
