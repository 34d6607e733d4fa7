// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/delaunay_complex.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace scan
{

/// How large a triangle is beside h, the largest local spacing of its vertices (see
/// localSpacing()).
class TriangleSize
{
public:
  TriangleSize(
    const DelaunayComplex& complex, const std::vector<float>& spacing, const Triangle& triangle)
    : H(std::max({ spacing[triangle[0]], spacing[triangle[1]], spacing[triangle[2]] }))
  {
    const Vec3& a = complex.points[triangle[0]];
    const Vec3 ab = complex.points[triangle[1]] - a;
    const Vec3 ac = complex.points[triangle[2]] - a;
    const Vec3 bc = ac - ab;
    const Vec3 normal = cross(ab, ac);
    this->Area2 = 0.25 * dot(normal, normal);
    this->Length2 = std::max({ dot(ab, ab), dot(ac, ac), dot(bc, bc) });
  }

  double spacing() const { return this->H; }                          ///< h
  double area() const { return std::sqrt(this->Area2) / this->h2(); } ///< in h^2

  /// By how much it is larger than triangles of a scanned surface are,
  /// max(0, area / h^2 - 2) + max(0, longest edge / h - 5): webs have area, needles and spikes to
  /// stray points have length.
  double excess() const
  {
    constexpr double kAllowedArea = 2.0;
    constexpr double kAllowedLength = 5.0;
    const double h2 = this->h2();
    double sum = 0.0;
    if (this->Area2 > kAllowedArea * kAllowedArea * h2 * h2)
    {
      sum += this->area() - kAllowedArea;
    }
    if (this->Length2 > kAllowedLength * kAllowedLength * h2)
    {
      sum += std::sqrt(this->Length2) / this->H - kAllowedLength;
    }
    return sum;
  }

private:
  double h2() const { return this->H * this->H; }

  double H;
  double Area2;   ///< squared
  double Length2; ///< of the longest edge, squared
};

} // namespace scan
