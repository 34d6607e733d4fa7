// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/half_edges.h"
#include "filters/geometry/local_plane.h"
#include "filters/geometry/mesh.h"
#include "filters/geometry/random.h"
#include "filters/geometry/self_intersections.h"
#include "filters/geometry/surface_edit.h"
#include "readers/off.h"
#include "readers/ply.h"
#include "tests/geometry/point_fixtures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

/// Surfaces with holes.
namespace scan::test
{

/// The unit sphere: an octahedron whose triangles were cut into four so many times.
inline TriMesh sphereMesh(int levels)
{
  TriMesh mesh{ { { 1, 0, 0 }, { -1, 0, 0 }, { 0, 1, 0 }, { 0, -1, 0 }, { 0, 0, 1 }, { 0, 0, -1 } },
    { { 0, 2, 4 }, { 2, 1, 4 }, { 1, 3, 4 }, { 3, 0, 4 }, { 2, 0, 5 }, { 1, 2, 5 }, { 3, 1, 5 },
      { 0, 3, 5 } } };
  for (int level = 0; level < levels; ++level)
  {
    std::map<std::pair<Index, Index>, Index> middles;
    const auto middle = [&](Index a, Index b)
    {
      const auto [found, isNew] =
        middles.try_emplace(std::minmax(a, b), static_cast<Index>(mesh.points.size()));
      if (isNew)
      {
        mesh.points.push_back(unitVector(mesh.points[a] + mesh.points[b]));
      }
      return found->second;
    };
    std::vector<Triangle> finer;
    for (const auto& [a, b, c] : mesh.triangles)
    {
      const Index ab = middle(a, b);
      const Index bc = middle(b, c);
      const Index ca = middle(c, a);
      finer.insert(finer.end(), { { a, ab, ca }, { ab, b, bc }, { ca, bc, c }, { ab, bc, ca } });
    }
    mesh.triangles.swap(finer);
  }
  return mesh;
}

inline Vec3 centroidOf(const TriMesh& mesh, const Triangle& t)
{
  return (mesh.points[t[0]] + mesh.points[t[1]] + mesh.points[t[2]]) * (1.0 / 3.0);
}

/// Without the triangles whose centroids `isGone` picks; all points stay.
template <class IsGone>
TriMesh torn(TriMesh mesh, IsGone&& isGone)
{
  std::erase_if(mesh.triangles, [&](const Triangle& t) { return isGone(centroidOf(mesh, t)); });
  return mesh;
}

/// A tube around the z axis with n quads around and `rows` along.
inline TriMesh tube(Index n, Index rows, double radius, double height, const Vec3& base = {})
{
  TriMesh mesh;
  for (Index row = 0; row <= rows; ++row)
  {
    for (Index i = 0; i < n; ++i)
    {
      const double angle = 2.0 * std::numbers::pi * i / n;
      mesh.points.push_back(
        base + Vec3{ radius * std::cos(angle), radius * std::sin(angle), height * row / rows });
    }
  }
  for (Index row = 0; row < rows; ++row)
  {
    for (Index i = 0; i < n; ++i)
    {
      const Index a = row * n + i;
      const Index b = row * n + (i + 1) % n;
      mesh.triangles.push_back({ a, b, b + n });
      mesh.triangles.push_back({ a, b + n, a + n });
    }
  }
  return mesh;
}

/// n × n quads of a square of side 1, as a hilly ground.
inline TriMesh terrain(Index n, double height = 0.05)
{
  TriMesh mesh;
  for (Index j = 0; j <= n; ++j)
  {
    for (Index i = 0; i <= n; ++i)
    {
      const double x = double(i) / n;
      const double y = double(j) / n;
      mesh.points.push_back({ x, y, height * std::sin(9.0 * x) * std::cos(7.0 * y) });
    }
  }
  for (Index j = 0; j < n; ++j)
  {
    for (Index i = 0; i < n; ++i)
    {
      const Index a = j * (n + 1) + i;
      mesh.triangles.push_back({ a, a + 1, a + n + 2 });
      mesh.triangles.push_back({ a, a + n + 2, a + n + 1 });
    }
  }
  return mesh;
}

/// Both in one.
inline TriMesh together(TriMesh mesh, const TriMesh& other)
{
  const auto first = static_cast<Index>(mesh.points.size());
  mesh.points.insert(mesh.points.end(), other.points.begin(), other.points.end());
  for (const auto& [a, b, c] : other.triangles)
  {
    mesh.triangles.push_back({ first + a, first + b, first + c });
  }
  return mesh;
}

/// An OFF or PLY file of the shared data; empty where it is missing.
inline TriMesh sharedMesh(const std::string& name)
{
  std::ifstream file(sharedFile(name), std::ios::binary);
  if (!file)
  {
    return {};
  }
  const std::string bytes{ std::istreambuf_iterator<char>(file), {} };
  Execution execution(1);
  return name.ends_with(".off") ? TriMesh(parseOff(bytes, name, execution))
                                : TriMesh(parsePly(bytes, name, execution));
}

/// Equal points are one, and collapsed triangles go.
inline TriMesh welded(TriMesh mesh)
{
  std::map<std::array<double, 3>, Index> first;
  for (Triangle& t : mesh.triangles)
  {
    for (Index& corner : t)
    {
      const Vec3& p = mesh.points[corner];
      corner = first.try_emplace({ p.x, p.y, p.z }, corner).first->second;
    }
  }
  std::erase_if(mesh.triangles, isCollapsed);
  return mesh;
}

/// How many triangle pairs intersect.
inline std::size_t intersectionsOf(const TriMesh& mesh)
{
  Execution execution(1);
  return selfIntersections(mesh, execution).size();
}

/// What every edit promises about the parts of its result.
inline void expectConsistent(const SurfaceEdit& edit)
{
  ASSERT_EQ(edit.pointOrigin.size(), edit.mesh.points.size());
  ASSERT_EQ(edit.triangleOrigin.size(), edit.mesh.triangles.size());
  ASSERT_EQ(
    static_cast<std::size_t>(std::ranges::count(edit.pointOrigin, kNone)), edit.blends.size());
  for (const PointBlend& blend : edit.blends)
  {
    EXPECT_NEAR(blend.weights[0] + blend.weights[1] + blend.weights[2], 1.0, 1e-9);
  }
}

} // namespace scan::test
