// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/point_triangle.h"

#include <algorithm>

namespace scan
{
namespace
{

Vec3 nearestPointOnSegment(const Vec3& p, const Vec3& a, const Vec3& b)
{
  const Vec3 ab = b - a;
  const double length2 = dot(ab, ab);
  const double t = length2 > 0.0 ? std::clamp(dot(p - a, ab) / length2, 0.0, 1.0) : 0.0;
  return a + ab * t;
}

} // namespace

Vec3 nearestPointOnTriangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c)
{
  const Vec3 normal = cross(b - a, c - a);
  const double area2 = dot(normal, normal);
  const double wa = dot(cross(c - b, p - b), normal);
  const double wb = dot(cross(a - c, p - c), normal);
  const double wc = dot(cross(b - a, p - a), normal);
  if (area2 > 0.0 && wa >= 0.0 && wb >= 0.0 && wc >= 0.0)
  {
    return p - normal * (dot(p - a, normal) / area2);
  }
  Vec3 nearest = a;
  double least = dot(p - a, p - a);
  for (const Vec3& q : { nearestPointOnSegment(p, a, b), nearestPointOnSegment(p, b, c),
         nearestPointOnSegment(p, c, a) })
  {
    if (const double distance2 = dot(p - q, p - q); distance2 < least)
    {
      least = distance2;
      nearest = q;
    }
  }
  return nearest;
}

} // namespace scan
