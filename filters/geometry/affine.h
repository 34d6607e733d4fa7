// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/mesh.h"

#include <cmath>

namespace scan
{

/// p -> x * p.x + y * p.y + z * p.z + origin, as files place parts; the identity by default.
struct Affine
{
  Vec3 x = { 1.0, 0.0, 0.0 };
  Vec3 y = { 0.0, 1.0, 0.0 };
  Vec3 z = { 0.0, 0.0, 1.0 };
  Vec3 origin;

  Vec3 direction(const Vec3& v) const { return this->x * v.x + this->y * v.y + this->z * v.z; }
  Vec3 point(const Vec3& p) const { return this->direction(p) + this->origin; }

  /// Whether left and right change places, and with them the two sides of a triangle.
  bool isMirror() const { return dot(this->x, cross(this->y, this->z)) < 0.0; }

  /// What becomes of the normal of a surface, with length 1, or 0 where there is none.
  Vec3 normal(const Vec3& n) const
  {
    const Vec3 scaled =
      cross(this->y, this->z) * n.x + cross(this->z, this->x) * n.y + cross(this->x, this->y) * n.z;
    const double length = std::sqrt(dot(scaled, scaled)) * (this->isMirror() ? -1.0 : 1.0);
    return std::isnormal(length) ? scaled * (1.0 / length) : Vec3{};
  }
};

/// The rotation by a quaternion of any length; the identity for one of length 0.
inline Affine rotationBy(double x, double y, double z, double w)
{
  const double length = x * x + y * y + z * z + w * w;
  const double k = length > 0.0 ? 2.0 / length : 0.0;
  return { { 1 - k * (y * y + z * z), k * (x * y + z * w), k * (x * z - y * w) },
    { k * (x * y - z * w), 1 - k * (x * x + z * z), k * (y * z + x * w) },
    { k * (x * z + y * w), k * (y * z - x * w), 1 - k * (x * x + y * y) }, {} };
}

/// First `inner`, then `outer`.
inline Affine operator*(const Affine& outer, const Affine& inner)
{
  return { outer.direction(inner.x), outer.direction(inner.y), outer.direction(inner.z),
    outer.point(inner.origin) };
}

} // namespace scan
