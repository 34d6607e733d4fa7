// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Random open patches with a known boundary, from the points to the open surface.
#include "filters/geometry/signed_rooms.h"

#include "filters/geometry/automatic_wrap.h"
#include "filters/geometry/mesh_checks.h"
#include "filters/geometry/outside_rooms.h"
#include "tests/geometry/complex_corpus.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace scan::test
{
namespace
{

/// A point of a patch at (u, v) in the unit square.
using Patch = std::function<Vec3(double u, double v)>;

struct Shape
{
  const char* name;
  Patch at;
  Index loops; ///< of its boundary
  std::int64_t euler;
};

void PrintTo(const Shape& shape, std::ostream* out)
{
  *out << shape.name;
}

Vec3 onSphere(double height, double turn)
{
  const double radius = std::sqrt(1.0 - height * height);
  const double angle = 2.0 * std::numbers::pi * turn;
  return { radius * std::cos(angle), radius * std::sin(angle), height };
}

/// One point at random in each cell of a grid on the unit square.
std::vector<Vec3> scanned(const Shape& shape, int columns, int rows, std::uint64_t seed)
{
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> place(0.1, 0.9);
  std::vector<Vec3> points;
  for (int i = 0; i < columns; ++i)
  {
    for (int j = 0; j < rows; ++j)
    {
      points.push_back(shape.at((i + place(random)) / columns, (j + place(random)) / rows));
    }
  }
  return points;
}

struct Wrapped
{
  AutomaticWrap wrap;
  TriMesh mesh;
};

Wrapped wrapped(const std::vector<Vec3>& points, Opening opening, unsigned threads = 0)
{
  Execution execution(threads);
  const DelaunayComplex complex = buildDelaunayComplex(points, execution);
  const FlowComplex flow(complex, execution);
  Wrapped result;
  result.wrap = wrapAutomatically(
    flow, findBasins(flow, execution), { .fineTune = true, .opening = opening }, execution);
  result.mesh.points = complex.points;
  for (const Facet facet : result.wrap.surface)
  {
    result.mesh.triangles.push_back(outwardVertices(complex, result.wrap.inside, facet));
  }
  return result;
}

class OpenPatches : public testing::TestWithParam<Shape>
{
};

TEST_P(OpenPatches, KeepEveryPointAndTheirBoundary)
{
  const Shape& shape = GetParam();
  for (std::uint64_t seed = testSeed(); seed < testSeed() + 3; ++seed)
  {
    SCOPED_TRACE("SCAN_TEST_SEED=" + std::to_string(seed));
    const std::vector<Vec3> points = scanned(shape, 60, 30, seed);
    for (const Opening opening : { Opening::automatic, Opening::keep })
    {
      const Wrapped result = wrapped(points, opening);
      const MeshReport mesh = describeMesh(result.mesh);
      EXPECT_TRUE(result.wrap.isOpen);
      EXPECT_EQ(mesh.pointsUsed, points.size());
      EXPECT_EQ(mesh.boundaryLoops, shape.loops);
      EXPECT_EQ(mesh.eulerCharacteristic, shape.euler);
      EXPECT_TRUE(mesh.isManifold);
      EXPECT_TRUE(mesh.isOriented);
    }
  }
}

TEST_P(OpenPatches, AreTheSameOnAnyNumberOfThreads)
{
  const std::vector<Vec3> points = scanned(GetParam(), 60, 30, testSeed());
  const Wrapped one = wrapped(points, Opening::automatic, 1);
  const Wrapped two = wrapped(points, Opening::automatic, 2);
  EXPECT_EQ(one.wrap.inside, two.wrap.inside);
  EXPECT_EQ(one.wrap.surface, two.wrap.surface);
}

TEST_P(OpenPatches, AreClosedWhenCapped)
{
  const Wrapped result = wrapped(scanned(GetParam(), 60, 30, testSeed()), Opening::cap);
  EXPECT_FALSE(result.wrap.isOpen);
  EXPECT_EQ(describeMesh(result.mesh).boundaryEdges, 0U);
}

INSTANTIATE_TEST_SUITE_P(Shapes, OpenPatches,
  testing::Values(
    Shape{ "halfSphere", [](double u, double v) { return onSphere(1.0 - 0.999 * v, u); }, 1, 1 },
    Shape{ "bowl", [](double u, double v) { return onSphere(1.0 - 1.5 * v, u); }, 1, 1 },
    Shape{ "tube",
      [](double u, double v)
      {
        const double turn = 2.0 * std::numbers::pi * u;
        const double radius = 1.0 + 0.2 * std::sin(2.0 * v);
        return Vec3{ radius * std::cos(turn), radius * std::sin(turn), 3.0 * v };
      },
      2, 0 },
    Shape{ "saddle",
      [](double u, double v)
      {
        const double x = 2.0 * u - 1.0;
        const double y = v - 0.5;
        return Vec3{ x, y, 0.5 * (x * x - 2.0 * y * y) };
      },
      1, 1 },
    Shape{ "dishOfVaryingDensity",
      [](double u, double v)
      {
        const double turn = 2.0 * std::numbers::pi * u;
        return Vec3{ v * std::cos(turn), v * std::sin(turn), 0.6 * v * v };
      },
      1, 1 }),
  [](const auto& test) { return std::string(test.param.name); });

TEST(OpenWrap, WavySheetIsOneOpenSurface)
{
  const Shape sheet{ "sheet",
    [](double u, double v) {
      return Vec3{ 2.0 * u, v, 0.15 * std::sin(4.0 * u) * std::cos(3.0 * v) };
    },
    1, 1 };
  const std::vector<Vec3> points = scanned(sheet, 60, 30, testSeed());
  const Wrapped result = wrapped(points, Opening::automatic);
  const MeshReport mesh = describeMesh(result.mesh);
  EXPECT_TRUE(result.wrap.isOpen);
  EXPECT_GT(result.wrap.openingTriangles, 0U);
  EXPECT_GE(mesh.pointsUsed, 0.99 * static_cast<double>(points.size()));
  ASSERT_FALSE(mesh.components.empty());
  EXPECT_GE(mesh.components.front().triangles, 0.98 * mesh.triangles);
  // nothing hangs over the sheet: its true area is 2.15, one layer
  EXPECT_NEAR(mesh.area, 2.1, 0.15);
}

TEST(SignedRooms, PartTheTwoSidesOfASheet)
{
  const Shape sheet{ "sheet",
    [](double u, double v) {
      return Vec3{ u, v, 0.1 * std::sin(5.0 * u) * std::sin(5.0 * v) };
    },
    1, 1 };
  Execution execution;
  const DelaunayComplex complex =
    buildDelaunayComplex(scanned(sheet, 40, 40, testSeed()), execution);
  const FlowComplex flow(complex, execution);
  const Basins basins = findBasins(flow, execution);
  std::vector<Wall> walls = findWalls(flow, basins, execution);
  std::erase_if(walls, [&](const Wall& wall) { return wall.b == basins.count(); });
  const std::vector<std::uint8_t> side =
    signedRooms(flow, basins, walls, basins.count(), execution);
  int above[2] = { 0, 0 };
  int below[2] = { 0, 0 };
  for (Index tet = 0; tet < complex.tetCount(); ++tet)
  {
    const auto& v = complex.tetrahedra[tet];
    const Vec3 middle =
      (complex.points[v[0]] + complex.points[v[1]] + complex.points[v[2]] + complex.points[v[3]]) *
      0.25;
    const double height = middle.z - sheet.at(middle.x, middle.y).z;
    constexpr double kClear = 0.02;
    if (std::abs(height) > kClear)
    {
      ++(height > 0.0 ? above : below)[side[basins.ofTet[tet]]];
    }
  }
  const int upper = above[1] > above[0] ? 1 : 0;
  EXPECT_GT(above[upper], 20 * above[1 - upper]);
  EXPECT_GT(below[1 - upper], 20 * below[upper]);
}

} // namespace
} // namespace scan::test
