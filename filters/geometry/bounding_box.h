// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/mesh.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace scan
{

/// The smallest axis-parallel box around points; of no points the origin.
struct BoundingBox
{
  Vec3 low;
  Vec3 high;

  explicit BoundingBox(std::span<const Vec3> points)
    : low(points.empty() ? Vec3{} : points.front())
    , high(low)
  {
    for (const Vec3& p : points)
    {
      this->low = { std::min(this->low.x, p.x), std::min(this->low.y, p.y),
        std::min(this->low.z, p.z) };
      this->high = { std::max(this->high.x, p.x), std::max(this->high.y, p.y),
        std::max(this->high.z, p.z) };
    }
  }

  /// Of a point from the box, 0 inside.
  double squaredDistance(const Vec3& p) const
  {
    const auto beyond = [](double at, double from, double to) {
      return std::max({ from - at, at - to, 0.0 });
    };
    const Vec3 d{ beyond(p.x, this->low.x, this->high.x), beyond(p.y, this->low.y, this->high.y),
      beyond(p.z, this->low.z, this->high.z) };
    return dot(d, d);
  }

  double diagonal() const
  {
    const Vec3 d = this->high - this->low;
    return std::sqrt(dot(d, d));
  }
};

} // namespace scan
