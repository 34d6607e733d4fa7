// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/mesh.h"
#include "filters/geometry/random.h"

#include <cmath>
#include <numbers>

/// Meshes for tests of what surfaces have in common and how far they are apart.
namespace meshes
{

using scan::Index;
using scan::TriMesh;
using scan::Vec3;

/// A number of [-1, 1).
inline double within1(scan::Random& random)
{
  return 2.0 * random.unit() - 1.0;
}

/// Triangles between random points: any of them flat or repeated, many in each other's way. On a
/// grid of a few numbers where `steps` is more than 0: in one plane or line, at one place.
inline TriMesh soup(scan::Random& random, Index points, Index triangles, int steps)
{
  TriMesh mesh;
  const auto coordinate = [&]
  {
    const double at = within1(random);
    return steps > 0 ? std::floor(at * steps) : at;
  };
  for (Index i = 0; i < points; ++i)
  {
    const double x = coordinate();
    const double y = coordinate();
    mesh.points.push_back({ x, y, coordinate() });
  }
  const auto corner = [&] { return static_cast<Index>(random.unit() * points); };
  for (Index i = 0; i < triangles; ++i)
  {
    const Index a = corner();
    const Index b = corner();
    mesh.triangles.push_back({ a, b, corner() });
  }
  return mesh;
}

/// A unit square in n x n squares of two triangles with heights.
template <class Height>
TriMesh ground(Index n, Height&& height)
{
  TriMesh mesh;
  for (Index i = 0; i <= n; ++i)
  {
    for (Index j = 0; j <= n; ++j)
    {
      const double x = static_cast<double>(i) / n;
      const double y = static_cast<double>(j) / n;
      mesh.points.push_back({ x, y, height(x, y) });
    }
  }
  for (Index i = 0; i < n; ++i)
  {
    for (Index j = 0; j < n; ++j)
    {
      const Index a = i * (n + 1) + j;
      const Index b = a + n + 1;
      mesh.triangles.push_back({ a, b, b + 1 });
      mesh.triangles.push_back({ a, b + 1, a + 1 });
    }
  }
  return mesh;
}

/// A sphere of about 2 n n triangles that faces outwards.
inline TriMesh sphere(Index n, double radius, const Vec3& centre = {})
{
  TriMesh mesh;
  mesh.points.push_back(centre + Vec3{ 0, 0, radius });
  for (Index i = 1; i < n; ++i)
  {
    for (Index j = 0; j < n; ++j)
    {
      const double latitude = std::numbers::pi * i / n;
      const double longitude = 2.0 * std::numbers::pi * j / n;
      mesh.points.push_back(centre +
        Vec3{ std::sin(latitude) * std::cos(longitude), std::sin(latitude) * std::sin(longitude),
          std::cos(latitude) } *
          radius);
    }
  }
  mesh.points.push_back(centre + Vec3{ 0, 0, -radius });
  const auto last = static_cast<Index>(mesh.points.size() - 1);
  const auto at = [n](Index i, Index j) { return 1 + (i - 1) * n + j % n; };
  for (Index j = 0; j < n; ++j)
  {
    mesh.triangles.push_back({ 0, at(1, j), at(1, j + 1) });
    for (Index i = 1; i + 1 < n; ++i)
    {
      mesh.triangles.push_back({ at(i, j), at(i + 1, j), at(i + 1, j + 1) });
      mesh.triangles.push_back({ at(i, j), at(i + 1, j + 1), at(i, j + 1) });
    }
    mesh.triangles.push_back({ at(n - 1, j), last, at(n - 1, j + 1) });
  }
  return mesh;
}

/// Puts a copy of another mesh beside what is there.
inline void add(TriMesh& mesh, TriMesh other)
{
  const auto first = static_cast<Index>(mesh.points.size());
  mesh.points.insert(mesh.points.end(), other.points.begin(), other.points.end());
  for (const auto& [a, b, c] : other.triangles)
  {
    mesh.triangles.push_back({ first + a, first + b, first + c });
  }
}

} // namespace meshes
