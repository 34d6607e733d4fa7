// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/local_plane.h"
#include "filters/geometry/mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

namespace scan
{

// Of triangles whose corners are there.

/// The places of a triangle's corners.
using CornerPlaces = std::array<Vec3, 3>;

inline CornerPlaces cornerPlaces(const TriMesh& mesh, Index triangle)
{
  const auto& [a, b, c] = mesh.triangles[triangle];
  return { mesh.points[a], mesh.points[b], mesh.points[c] };
}

/// Along the normal, as long as twice the area.
inline Vec3 areaVector(std::span<const Vec3> points, const Triangle& triangle)
{
  const auto& [a, b, c] = triangle;
  return cross(points[b] - points[a], points[c] - points[a]);
}

inline double areaOf(std::span<const Vec3> points, const Triangle& triangle)
{
  return length(areaVector(points, triangle)) / 2.0;
}

/// Of length 1; (0, 0, 0) without area.
inline Vec3 normalOf(std::span<const Vec3> points, const Triangle& triangle)
{
  return unitVector(areaVector(points, triangle));
}

/// The mean of the corners.
inline Vec3 middleOf(std::span<const Vec3> points, const Triangle& triangle)
{
  const auto& [a, b, c] = triangle;
  return (points[a] + points[b] + points[c]) * (1.0 / 3.0);
}

/// At corner k, from 0 to pi.
inline double angleAt(std::span<const Vec3> points, const Triangle& triangle, std::size_t k)
{
  const Vec3& corner = points[triangle[k]];
  const Vec3 ahead = unitVector(points[triangle[(k + 1) % 3]] - corner);
  const Vec3 back = unitVector(points[triangle[(k + 2) % 3]] - corner);
  return std::acos(std::clamp(dot(ahead, back), -1.0, 1.0));
}

} // namespace scan
