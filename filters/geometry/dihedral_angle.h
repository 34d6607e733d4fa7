// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/mesh.h"

#include <cmath>

namespace scan
{

/// The angle in [0, pi] between the half-planes from the line u v through a and through b.
inline double dihedralAngle(const Vec3& u, const Vec3& v, const Vec3& a, const Vec3& b)
{
  const Vec3 axis = v - u;
  const Vec3 na = cross(axis, a - u);
  const Vec3 nb = cross(axis, b - u);
  const Vec3 sine = cross(na, nb);
  return std::atan2(std::sqrt(dot(sine, sine)), dot(na, nb));
}

} // namespace scan
