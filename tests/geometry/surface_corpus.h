// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/mesh.h"
#include "filters/geometry/mesh_checks.h"
#include "filters/geometry/random.h"
#include "tests/geometry/mesh_corpus.h"

#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

/// Larger meshes for operations that move, add or remove points.
namespace corpus
{

using scan::Triangle;
using scan::Vec3;

/// n × n quads over the square [-1, 1]², at the heights of a function, two triangles each.
template <class Height>
TriMesh sheet(Index n, Height&& height)
{
  TriMesh mesh;
  for (Index i = 0; i <= n; ++i)
  {
    for (Index j = 0; j <= n; ++j)
    {
      const double x = 2.0 * i / n - 1.0;
      const double y = 2.0 * j / n - 1.0;
      mesh.points.push_back({ x, y, height(x, y) });
      if (i < n && j < n)
      {
        const Index at = i * (n + 1) + j;
        mesh.triangles.push_back({ at, at + n + 1, at + n + 2 });
        mesh.triangles.push_back({ at, at + n + 2, at + 1 });
      }
    }
  }
  return mesh;
}

/// z = s (x³ - 3 x y²).
inline TriMesh monkeySaddle(Index n, double s)
{
  return sheet(n, [&](double x, double y) { return s * (x * x * x - 3.0 * x * y * y); });
}

/// Every edge cut in the middle.
inline TriMesh midpoints(const TriMesh& mesh)
{
  TriMesh fine{ mesh.points, {} };
  std::map<std::pair<Index, Index>, Index> middles;
  const auto middle = [&](Index a, Index b)
  {
    const auto [place, isNew] =
      middles.insert({ std::minmax(a, b), static_cast<Index>(fine.points.size()) });
    if (isNew)
    {
      fine.points.push_back((mesh.points[a] + mesh.points[b]) * 0.5);
    }
    return place->second;
  };
  for (const auto& [a, b, c] : mesh.triangles)
  {
    const Index ab = middle(a, b);
    const Index bc = middle(b, c);
    const Index ca = middle(c, a);
    fine.triangles.insert(
      fine.triangles.end(), { { a, ab, ca }, { ab, b, bc }, { ca, bc, c }, { ab, bc, ca } });
  }
  return fine;
}

/// Radius 1, from an octahedron; 8 · 4^depth triangles.
inline TriMesh sphere(int depth)
{
  TriMesh mesh{ { { 1, 0, 0 }, { -1, 0, 0 }, { 0, 1, 0 }, { 0, -1, 0 }, { 0, 0, 1 }, { 0, 0, -1 } },
    { { 0, 2, 4 }, { 2, 1, 4 }, { 1, 3, 4 }, { 3, 0, 4 }, { 2, 0, 5 }, { 1, 2, 5 }, { 3, 1, 5 },
      { 0, 3, 5 } } };
  for (int i = 0; i < depth; ++i)
  {
    mesh = midpoints(mesh);
    for (Vec3& p : mesh.points)
    {
      p = p * (1.0 / std::sqrt(dot(p, p)));
    }
  }
  return mesh;
}

/// The cube [0, n]³ in unit squares of two triangles, closed.
inline TriMesh cube(Index n)
{
  TriMesh mesh = voxelBorder(n, [](Index, Index, Index) { return true; });
  std::vector<Index> place(mesh.points.size(), scan::kNone);
  std::vector<Vec3> points;
  for (Triangle& triangle : mesh.triangles)
  {
    for (Index& point : triangle)
    {
      if (place[point] == scan::kNone)
      {
        place[point] = static_cast<Index>(points.size());
        points.push_back(mesh.points[point]);
      }
      point = place[point];
    }
  }
  mesh.points = points;
  return mesh;
}

/// Meshes that are and are not manifold, closed, oriented, embedded.
inline std::vector<std::pair<std::string, TriMesh>> surfaces()
{
  std::vector<std::pair<std::string, TriMesh>> all = { { "tetrahedron", tetrahedron() },
    { "square", square() }, { "tetrahedra on an edge", tetrahedraOnOneEdge() },
    { "tetrahedra on a point", tetrahedraOnOnePoint() }, { "moebius", moebius() },
    { "torus", torus(16) }, { "sphere", sphere(3) }, { "cube", cube(4) },
    { "saddle", monkeySaddle(12, 0.5) } };
  TriMesh holes = torus(16);
  for (std::size_t t = 0; t < holes.triangles.size(); t += 7)
  {
    holes.triangles.erase(holes.triangles.begin() + static_cast<std::ptrdiff_t>(t));
  }
  all.emplace_back("torus with holes", holes);
  TriMesh flipped = sphere(2);
  for (std::size_t t = 0; t < flipped.triangles.size(); t += 5)
  {
    std::swap(flipped.triangles[t][0], flipped.triangles[t][1]);
  }
  all.emplace_back("sphere with flipped triangles", flipped);
  TriMesh fin = cube(2);
  fin.points.push_back({ 5, 5, 5 });
  fin.triangles.push_back({ 0, 1, static_cast<Index>(fin.points.size() - 1) });
  fin.triangles.push_back(fin.triangles[3]);
  fin.triangles.push_back({ 2, 2, 3 });
  all.emplace_back("cube with a fin, a repeat and a collapsed triangle", fin);
  all.emplace_back("voxels",
    voxelBorder(
      4, [](Index i, Index j, Index k) { return (i * 7 + j * 5 + k * 3 + i * j * k) % 3 == 0; }));
  TriMesh flat = square();
  flat.points.push_back({ 0.5, 0.0, 0.0 });
  flat.triangles.push_back({ 0, 1, 4 });
  all.emplace_back("square with a flat triangle", flat);
  all.emplace_back(
    "flat triangle", TriMesh{ { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 } }, { { 0, 1, 2 } } });
  all.emplace_back("folded triangles",
    TriMesh{
      { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 1, 0 } }, { { 0, 1, 2 }, { 1, 0, 3 } } });
  return all;
}

/// Every third triangle at random, in patches.
inline std::vector<std::uint8_t> randomRegion(const TriMesh& mesh, std::uint64_t seed)
{
  scan::Random random(seed);
  const Vec3 normal{ random.unit() - 0.5, random.unit() - 0.5, random.unit() - 0.5 };
  std::vector<std::uint8_t> inRegion;
  for (const auto& [a, b, c] : mesh.triangles)
  {
    const double height = dot(normal, mesh.points[a] + mesh.points[b] + mesh.points[c]);
    const bool isStray = random.unit() < 0.1;
    inRegion.push_back((height > 0.0) != isStray ? 1 : 0);
  }
  return inRegion;
}

} // namespace corpus
