// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/geometry/refine_fixtures.h"

#include "filters/geometry/half_edges.h"
#include "filters/geometry/local_plane.h"
#include "filters/geometry/wrap.h"
#include "tests/geometry/mesh_corpus.h"
#include "tests/geometry/point_fixtures.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace scan::test
{
namespace
{

/// A height field of n x n squares; without the squares that isHole picks.
template <class Height, class IsHole>
TriMesh heightField(Index n, Height&& height, IsHole&& isHole)
{
  TriMesh mesh;
  for (Index j = 0; j <= n; ++j)
  {
    for (Index i = 0; i <= n; ++i)
    {
      const double x = 2.0 * i / n - 1.0;
      const double y = 2.0 * j / n - 1.0;
      mesh.points.push_back({ x, y, height(x, y) });
    }
  }
  for (Index j = 0; j < n; ++j)
  {
    for (Index i = 0; i < n; ++i)
    {
      const Index a = j * (n + 1) + i;
      if (!isHole(i, j))
      {
        mesh.triangles.push_back({ a, a + 1, a + n + 2 });
        mesh.triangles.push_back({ a, a + n + 2, a + n + 1 });
      }
    }
  }
  return mesh;
}

TriMesh sphere(int times)
{
  TriMesh mesh = bipyramid(4);
  for (int i = 0; i < times; ++i)
  {
    mesh = refined(mesh, { .mode = RefineOptions::Mode::midpoint }, allOf(mesh)).edit.mesh;
    std::ranges::for_each(mesh.points, [](Vec3& p) { p = unitVector(p); });
  }
  return mesh;
}

TriMesh shaken(TriMesh mesh, double deviation, std::uint64_t seed)
{
  Random random(seed);
  std::ranges::for_each(mesh.points, [&](Vec3& p) { p = p + noise(random, deviation); });
  return mesh;
}

TriMesh wrapOf(const std::vector<Vec3>& points)
{
  Execution execution(2);
  return wrap(points, {}, execution).surface;
}

/// A disc around one point.
TriMesh fan(Index n, bool isClosed)
{
  TriMesh mesh;
  mesh.points.push_back({ 0, 0, 1 });
  for (Index i = 0; i <= n; ++i)
  {
    const double angle = (isClosed ? 2.0 : 1.0) * std::numbers::pi * i / n;
    mesh.points.push_back({ std::cos(angle), std::sin(angle), 0.1 * (i % 3) });
  }
  for (Index i = 0; i < n; ++i)
  {
    mesh.triangles.push_back({ 0, 1 + i, isClosed && i + 1 == n ? 1 : 2 + i });
  }
  return mesh;
}

} // namespace

TriMesh bipyramid(Index n)
{
  TriMesh mesh;
  mesh.points = { { 0, 0, 1 }, { 0, 0, -1 } };
  for (Index i = 0; i < n; ++i)
  {
    const double angle = 2.0 * std::numbers::pi * i / n;
    mesh.points.push_back({ std::cos(angle), std::sin(angle), 0.0 });
    mesh.triangles.push_back({ 0, 2 + i, 2 + (i + 1) % n });
    mesh.triangles.push_back({ 1, 2 + (i + 1) % n, 2 + i });
  }
  return mesh;
}

TriMesh monkeySaddle(Index n)
{
  return heightField(
    n, [](double x, double y) { return x * x * x - 3.0 * x * y * y; },
    [](Index, Index) { return false; });
}

std::vector<NamedMesh> manifolds()
{
  const auto wave = [](double x, double y) { return 0.3 * std::sin(3.0 * x) * std::cos(2.0 * y); };
  return { { "tetrahedron", corpus::tetrahedron() }, { "octahedron", bipyramid(4) },
    { "bipyramid of 3", bipyramid(3) }, { "bipyramid of 7", bipyramid(7) },
    { "bipyramid of 40", bipyramid(40) }, { "sphere", sphere(3) },
    { "shaken sphere", shaken(sphere(3), 0.02, 3) }, { "torus", corpus::torus(12) },
    { "fine torus", corpus::torus(24) }, { "shaken torus", shaken(corpus::torus(16), 0.05, 4) },
    { "square", corpus::square() },
    { "triangle", { { { 0, 0, 0 }, { 1, 0, 0 }, { 0.3, 1, 2 } }, { { 0, 1, 2 } } } },
    { "saddle", monkeySaddle(12) },
    { "wave with holes",
      heightField(12, wave, [](Index i, Index j) { return i % 5 == 2 && j % 4 == 2; }) },
    { "random heights", shaken(monkeySaddle(9), 0.06, 5) }, { "fan", fan(9, false) },
    { "closed fan", fan(5, true) }, { "wrap of a sphere", wrapOf(sphereTruth(400, 6).points) },
    { "wrap of a torus", wrapOf(torusTruth(1500, 7).points) },
    { "wrap of a sheet", wrapOf(sheetTruth(900, 8).points) } };
}

std::vector<NamedMesh> awkwardMeshes()
{
  std::vector<NamedMesh> meshes{ { "nothing", {} }, { "one edge", corpus::tetrahedraOnOneEdge() },
    { "one point", corpus::tetrahedraOnOnePoint() }, { "moebius", corpus::moebius() },
    { "book",
      { { { 0, 0, 0 }, { 0, 0, 1 }, { 1, 0, 0 }, { 0, 1, 0 }, { -1, 0, 0 } },
        { { 0, 1, 2 }, { 1, 0, 3 }, { 0, 1, 4 } } } } };
  Random random(9);
  std::array<bool, 64> isSolid{};
  std::ranges::generate(isSolid, [&] { return random.below(2) == 0; });
  meshes.push_back({ "voxels",
    corpus::voxelBorder(
      4, [&](Index i, Index j, Index k) { return isSolid.at(i + 4 * j + 16 * k); }) });
  TriMesh twice = corpus::torus(6);
  twice.triangles.push_back(twice.triangles[3]);
  twice.triangles.push_back({ 0, 0, 1 });
  twice.triangles.push_back({ 5, 5, 5 });
  std::swap(twice.triangles[7][0], twice.triangles[7][1]);
  twice.points.push_back({ 9, 9, 9 });
  meshes.push_back({ "doubled, collapsed, turned", twice });
  TriMesh flat = monkeySaddle(4);
  std::ranges::for_each(flat.points, [](Vec3& p) { p = { p.x, 0.0, 0.0 }; });
  meshes.push_back({ "without area", flat });
  return meshes;
}

std::vector<std::uint8_t> randomRegion(const TriMesh& mesh, Random& random)
{
  std::vector<std::uint8_t> region(mesh.triangles.size(), 0);
  const auto corner = [&](Index t, Index k) { return mesh.points[mesh.triangles[t][k]]; };
  if (random.below(3) == 0)
  {
    std::ranges::generate(region, [&] { return random.below(6) == 0 ? 1 : 0; });
    return region;
  }
  const auto middle = corner(static_cast<Index>(random.below(region.size())), 0);
  const double radius = 0.2 + random.unit();
  for (Index t = 0; t < region.size(); ++t)
  {
    region[t] = length(corner(t, 0) - middle) < radius ? 1 : 0;
  }
  return region;
}

RefineResult refined(const TriMesh& mesh, const RefineOptions& options,
  const std::vector<std::uint8_t>& isChosen, const std::vector<std::uint8_t>& halves,
  unsigned threads)
{
  Execution execution(threads);
  return refine(mesh, isChosen, halves, options, execution);
}

double smallestAngle(const TriMesh& mesh)
{
  double smallest = std::numbers::pi;
  for (const Triangle& t : mesh.triangles)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Vec3 a = mesh.points[t[(k + 1) % 3]] - mesh.points[t[k]];
      const Vec3 b = mesh.points[t[(k + 2) % 3]] - mesh.points[t[k]];
      smallest = std::min(smallest, std::atan2(length(cross(a, b)), dot(a, b)));
    }
  }
  return smallest;
}

double largestBend(const TriMesh& mesh)
{
  const EdgePairs pairs = pairEdges(mesh);
  const auto normal = [&](Index t)
  {
    const auto& [a, b, c] = mesh.triangles[t];
    return cross(mesh.points[b] - mesh.points[a], mesh.points[c] - mesh.points[a]);
  };
  double largest = 0.0;
  for (Index half = 0; half < pairs.mate.size(); ++half)
  {
    if (pairs.mate[half] != kNone)
    {
      const Vec3 a = normal(half / 3);
      const Vec3 b = normal(pairs.mate[half] / 3);
      largest = std::max(largest, std::atan2(length(cross(a, b)), dot(a, b)));
    }
  }
  return largest;
}

} // namespace scan::test
