// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
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

/// Lines through points, each as indices into a point array. A closed line ends with its first
/// point.
struct Polylines
{
  std::vector<Index> corners;    ///< of all lines, one after the other
  std::vector<std::size_t> ends; ///< per line: where it ends in corners

  bool empty() const { return this->ends.empty(); }
  std::size_t size() const { return this->ends.size(); }

  std::span<const Index> operator[](std::size_t line) const
  {
    const std::size_t begin = line > 0 ? this->ends[line - 1] : 0;
    return { this->corners.data() + begin, this->corners.data() + this->ends[line] };
  }

  /// Makes a line of the corners behind the last one; fewer than two are dropped.
  void endLine()
  {
    const std::size_t begin = this->empty() ? 0 : this->ends.back();
    if (this->corners.size() < begin + 2)
    {
      this->corners.resize(begin);
      return;
    }
    this->ends.push_back(this->corners.size());
  }

  friend bool operator==(const Polylines&, const Polylines&) = default;
};

/// Whether a line of Polylines is closed.
inline bool isClosed(std::span<const Index> line)
{
  return line.front() == line.back();
}

/// Points and the triangles on them. Points without triangles are a scan; points that no triangle
/// uses are allowed beside triangles.
struct TriMesh
{
  std::vector<Vec3> points;
  std::vector<Triangle> triangles;
};

} // namespace scan
