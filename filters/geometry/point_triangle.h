// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/mesh.h"

namespace scan
{

/// The point of the closed triangle abc that is nearest to p. Works for triangles of any shape,
/// collapsed ones too.
Vec3 nearestPointOnTriangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c);

/// Its squared distance from p.
inline double squaredDistance(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c)
{
  const Vec3 d = p - nearestPointOnTriangle(p, a, b, c);
  return dot(d, d);
}

} // namespace scan
