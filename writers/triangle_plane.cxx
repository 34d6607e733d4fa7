// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/triangle_plane.h"

#include <array>
#include <cmath>

namespace scan
{
namespace
{

// Differences of neighbouring points are exact, so long double makes up for the cancellation in the
// cross product of a thin triangle.
using Exact = std::array<long double, 3>;

Exact difference(const Vec3& a, const Vec3& b)
{
  return { static_cast<long double>(a.x) - b.x, static_cast<long double>(a.y) - b.y,
    static_cast<long double>(a.z) - b.z };
}

Exact crossOf(const Exact& a, const Exact& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

long double lengthOf(const Exact& v)
{
  return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

Vec3 scaled(const Exact& v, long double length)
{
  return { static_cast<double>(v[0] / length), static_cast<double>(v[1] / length),
    static_cast<double>(v[2] / length) };
}

long double exactDot(const Vec3& a, const Vec3& b)
{
  return static_cast<long double>(a.x) * b.x + static_cast<long double>(a.y) * b.y +
    static_cast<long double>(a.z) * b.z;
}

} // namespace

std::optional<TrianglePlane> planeOf(const Vec3& a, const Vec3& b, const Vec3& c)
{
  const Exact along = difference(b, a);
  const Exact normal = crossOf(along, difference(c, a));
  const long double area = lengthOf(normal);
  if (!(area > 0.0L))
  {
    return std::nullopt;
  }
  TrianglePlane plane{ .normal = scaled(normal, area), .along = scaled(along, lengthOf(along)) };
  const Vec3& n = plane.normal;
  plane.offset = static_cast<double>((exactDot(n, a) + exactDot(n, b) + exactDot(n, c)) / 3.0L);
  return plane;
}

} // namespace scan
