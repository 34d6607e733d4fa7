// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/neighbours.h"

#include <array>
#include <cmath>
#include <span>

namespace scan
{

inline double length(const Vec3& v)
{
  return std::sqrt(dot(v, v));
}

/// The vector with length 1; (0, 0, 0) stays.
inline Vec3 unitVector(const Vec3& v)
{
  const double size = length(v);
  return size > 0.0 ? v * (1.0 / size) : v;
}

/// The plane that fits points best, by principal components.
struct LocalPlane
{
  Vec3 middle;
  Vec3 normal; ///< of length 1 and either sign; (0, 0, 0) where the points are on a line or equal
  Vec3 first;  ///< in the plane, where the points spread most; with second and normal a frame
  Vec3 second;
  std::array<double, 3> spread{}; ///< variance along normal, second and first: rising

  /// How far from flat: 0 in a plane, up to 1/3 in space (Pauly, Gross, Kobbelt 2002).
  double variation() const
  {
    const double sum = this->spread[0] + this->spread[1] + this->spread[2];
    return sum > 0.0 ? this->spread[0] / sum : 0.0;
  }
};

/// The plane through places; neither of them depends on an order.
LocalPlane fitPlane(const Neighbours& places, std::span<const Neighbour> found);

} // namespace scan
