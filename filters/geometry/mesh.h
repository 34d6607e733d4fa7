// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace scan
{

/// Index of a point, triangle or tetrahedron in its array.
using Index = std::uint32_t;

/// "None": no neighbour, no owner, not on the surface.
inline constexpr Index kNone = 0xffffffffU;

/// A point or vector, in model units.
struct Vec3
{
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;

  friend bool operator==(const Vec3&, const Vec3&) = default;
};

inline Vec3 operator+(const Vec3& a, const Vec3& b)
{
  return { a.x + b.x, a.y + b.y, a.z + b.z };
}
inline Vec3 operator-(const Vec3& a, const Vec3& b)
{
  return { a.x - b.x, a.y - b.y, a.z - b.z };
}
inline Vec3 operator*(const Vec3& a, double s)
{
  return { a.x * s, a.y * s, a.z * s };
}
inline double dot(const Vec3& a, const Vec3& b)
{
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Vec3 cross(const Vec3& a, const Vec3& b)
{
  return { a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x };
}

/// Three indices into a point array, counter-clockwise seen from outside.
using Triangle = std::array<Index, 3>;

/// An open or closed line: two indices into a point array.
using Segment = std::array<Index, 2>;

/// Points and the triangles on them. Points without triangles are a scan; points that no triangle
/// uses are allowed beside triangles.
struct TriMesh
{
  std::vector<Vec3> points;
  std::vector<Triangle> triangles;
};

} // namespace scan
