// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/triangle_size.h"

#include <algorithm>
#include <cmath>

namespace scan
{

double TriangleSize::excess() const
{
  constexpr double kAllowedArea = 2.0;
  constexpr double kAllowedLength = 5.0;
  return std::max(0.0, this->area - kAllowedArea) + std::max(0.0, this->length - kAllowedLength);
}

TriangleSize triangleSize(
  const DelaunayComplex& complex, const std::vector<float>& spacing, const Triangle& triangle)
{
  const Vec3& a = complex.points[triangle[0]];
  const Vec3 ab = complex.points[triangle[1]] - a;
  const Vec3 ac = complex.points[triangle[2]] - a;
  const Vec3 bc = ac - ab;
  const Vec3 normal = cross(ab, ac);
  const double h = std::max({ spacing[triangle[0]], spacing[triangle[1]], spacing[triangle[2]] });
  const double twiceArea = std::sqrt(dot(normal, normal));
  const double edges = std::sqrt(dot(ab, ab)) * std::sqrt(dot(ac, ac)) * std::sqrt(dot(bc, bc));
  return { .area = 0.5 * twiceArea / (h * h),
    .length = std::sqrt(std::max({ dot(ab, ab), dot(ac, ac), dot(bc, bc) })) / h,
    .radius = edges / (2.0 * twiceArea * h) };
}

} // namespace scan
