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
  const double along = dot(p - a, ab);
  const double length2 = dot(ab, ab);
  if (!(along > 0.0))
  {
    return a;
  }
  return along < length2 ? a + ab * (along / length2) : b;
}

} // namespace

Vec3 nearestPointOnTriangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c)
{
  const Vec3 ab = b - a;
  const Vec3 ac = c - a;
  const Vec3 bc = c - b;
  const Vec3 ap = p - a;
  const Vec3 normal = cross(ab, ac);
  const double area2 = dot(normal, normal);
  const double wa = dot(cross(bc, p - b), normal);
  const double wb = dot(cross(ap, ac), normal);
  const double wc = dot(cross(ab, ap), normal);
  constexpr double kSure = 1e-10; // the squared sine where rounding begins to turn the normal
  const bool isSure = area2 > kSure * dot(ab, ab) * dot(ac, ac);
  const bool isWithin = wa >= 0.0 && wb >= 0.0 && wc >= 0.0;
  if (isSure && isWithin)
  {
    return p - normal * (dot(ap, normal) / area2);
  }
  // the nearest point is on an edge that p is beyond
  Vec3 nearest = a;
  double least = dot(ap, ap);
  const auto look = [&](const Vec3& q)
  {
    if (const double distance2 = dot(p - q, p - q); distance2 < least)
    {
      least = distance2;
      nearest = q;
    }
  };
  if (!isSure || wc < 0.0)
  {
    look(nearestPointOnSegment(p, a, b));
  }
  if (!isSure || wa < 0.0)
  {
    look(nearestPointOnSegment(p, b, c));
  }
  if (!isSure || wb < 0.0)
  {
    look(nearestPointOnSegment(p, c, a));
  }
  const double sum = wa + wb + wc;
  if (!isSure && isWithin && sum > 0.0)
  {
    look(a + ab * (wb / sum) + ac * (wc / sum));
  }
  return nearest;
}

} // namespace scan
