// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/thicken.h"

#include "filters/base/error.h"
#include "filters/geometry/half_edges.h"
#include "filters/geometry/triangle_tree.h"
#include "filters/geometry/wrap.h"
#include "tests/geometry/point_fixtures.h"
#include "tests/geometry/surface_corpus.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <numbers>
#include <set>

namespace scan::test
{
namespace
{

using corpus::surfaces;

std::vector<std::uint8_t> allOf(const TriMesh& mesh)
{
  return std::vector<std::uint8_t>(mesh.triangles.size(), 1);
}

ThickenResult run(const TriMesh& mesh, const ThickenOptions& options, unsigned threads = 2)
{
  Execution execution(threads);
  return thicken(mesh, allOf(mesh), options, execution);
}

/// The wrapped sample.
TriMesh saddleSurface()
{
  const std::vector<Vec3> points = pointsOfFile(sampleFile("monkey_saddle.xyz"));
  Execution execution(2);
  return wrap(points, {}, execution).surface;
}

void expectSolid(const ThickenResult& result, const std::string& name)
{
  const MeshReport report = describeMesh(result.edit.mesh);
  EXPECT_TRUE(report.isClosed) << name;
  EXPECT_TRUE(report.isManifold) << name;
  EXPECT_TRUE(report.isOriented) << name;
  EXPECT_EQ(result.edit.pointOrigin.size(), result.edit.mesh.points.size()) << name;
  EXPECT_EQ(result.edit.triangleOrigin.size(), result.edit.mesh.triangles.size()) << name;
  EXPECT_EQ(result.folds.isFolded.size(), result.edit.mesh.triangles.size()) << name;
}

/// How far the point is from the rim of the surface.
double distanceFromRim(const Vec3& at, const TriMesh& mesh, const std::vector<Index>& rim)
{
  double least = std::numeric_limits<double>::infinity();
  for (const Index point : rim)
  {
    least = std::min(least, length(mesh.points[point] - at));
  }
  return least;
}

std::vector<Index> rimOf(const TriMesh& mesh)
{
  const EdgePairs pairs = pairEdges(mesh);
  std::vector<Index> rim;
  for (Index half = 0; half < pairs.mate.size(); ++half)
  {
    if (pairs.mate[half] == kNone)
    {
      rim.push_back(originOf(mesh, half));
    }
  }
  return rim;
}

TEST(Thicken, MakesTheSaddleASolidOfUniformThickness)
{
  const TriMesh saddle = corpus::midpoints(saddleSurface());
  const std::vector<Index> rim = rimOf(saddle);
  ASSERT_EQ(describeMesh(saddle).boundaryLoops, 1U);
  constexpr double kThickness = 0.06;
  for (const ThickenSide side : { ThickenSide::both, ThickenSide::out, ThickenSide::in })
  {
    const ThickenResult result = run(saddle, { .thickness = kThickness, .side = side });
    const TriMesh& solid = result.edit.mesh;
    const MeshReport report = describeMesh(solid);
    expectSolid(result, "saddle");
    EXPECT_EQ(report.components.size(), 1U);
    EXPECT_EQ(report.genus, 0);
    EXPECT_EQ(result.folds.folded, 0U);
    EXPECT_EQ(result.strip, 2 * rim.size());
    EXPECT_NEAR(*report.volume, kThickness * describeMesh(saddle).area,
      0.02 * kThickness * describeMesh(saddle).area);

    // of each point of a copy from the other copy
    Execution execution(2);
    const std::size_t triangles = saddle.triangles.size();
    const auto begin = solid.triangles.begin();
    const TriMesh front{ solid.points, { begin, begin + std::ptrdiff_t(triangles) } };
    const TriMesh back{ solid.points,
      { begin + std::ptrdiff_t(triangles), begin + std::ptrdiff_t(2 * triangles) } };
    const TriangleTree frontTree(front, execution);
    const TriangleTree backTree(back, execution);
    double least = kThickness;
    double most = kThickness;
    double sum = 0.0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < solid.points.size(); ++i)
    {
      const std::size_t of = i % saddle.points.size();
      if (distanceFromRim(saddle.points[of], saddle, rim) > 1.5 * kThickness)
      {
        const TriangleTree& other = i == of ? backTree : frontTree;
        const double distance = std::sqrt(other.nearest(solid.points[i]).squaredDistance);
        least = std::min(least, distance);
        most = std::max(most, distance);
        sum += distance;
        ++count;
      }
    }
    ASSERT_GT(count, saddle.points.size());
    std::cout << "thickness / wanted: least " << least / kThickness << ", mean "
              << sum / double(count) / kThickness << ", most " << most / kThickness << " at "
              << count << " points\n";
    EXPECT_GT(least, 0.98 * kThickness);
    EXPECT_LT(most, 1.02 * kThickness);
  }
}

/// Its least radius of curvature is 0.59.
TEST(Thicken, TellsWhereTheSaddleFolds)
{
  const TriMesh saddle = saddleSurface();
  for (const double thickness : { 0.3, 1.0, 1.3, 1.5 })
  {
    const ThickenResult result = run(saddle, { .thickness = thickness });
    const SurfaceFolds& folds = result.folds;
    expectSolid(result, "saddle");
    std::cout << "thickness " << thickness << ": turned " << folds.turned << ", shrunk "
              << folds.shrunk << ", crossing " << folds.crossing << ", folded " << folds.folded
              << " in " << folds.places.size() << " places\n";
    EXPECT_EQ(folds.folded, std::ranges::count(folds.isFolded, 1));
    EXPECT_EQ(folds.folded > 0, !folds.places.empty());
    EXPECT_EQ(folds.folded > 0, thickness > 2.0 * 0.59);
    EXPECT_TRUE(thickness < 1.5 || folds.turned > 500);
  }
}

/// Curved with a radius of 1 to the inside only.
TEST(Thicken, FoldsWhereTheRadiusOfCurvatureIsLessThanTheThickness)
{
  const TriMesh sphere = corpus::sphere(4);
  const auto of = [&](double thickness, ThickenSide side)
  { return run(sphere, { .thickness = thickness, .side = side }).folds; };
  EXPECT_EQ(of(0.7, ThickenSide::in).folded, 0U);
  EXPECT_EQ(of(5.0, ThickenSide::out).folded, 0U);
  EXPECT_EQ(of(1.5, ThickenSide::in).turned, sphere.triangles.size());
  const SurfaceFolds toThePoint = of(1.0, ThickenSide::in);
  EXPECT_GT(toThePoint.shrunk + toThePoint.turned, sphere.triangles.size() * 9 / 10);
}

TEST(Thicken, FindsTheSheetsThatRunIntoEachOther)
{
  TriMesh sheets = corpus::sheet(10, [](double, double) { return 0.0; });
  const TriMesh other = corpus::sheet(10, [](double x, double) { return 0.12 + 0.1 * x; });
  for (const auto& [a, b, c] : other.triangles)
  {
    sheets.triangles.push_back({ a + 121, b + 121, c + 121 });
  }
  sheets.points.insert(sheets.points.end(), other.points.begin(), other.points.end());
  const ThickenResult result = run(sheets, { .thickness = 0.1, .side = ThickenSide::both });
  expectSolid(result, "sheets");
  EXPECT_EQ(result.folds.turned + result.folds.shrunk, 0U);
  EXPECT_GT(result.folds.crossing, 0U);
  ASSERT_EQ(result.folds.places.size(), 1U);
  EXPECT_LT(result.folds.places[0].x, 0.0); // where they are near each other
}

TEST(Thicken, KeepsThePlanesOfACubeAtTheThickness)
{
  const TriMesh cube = corpus::cube(4);
  const ThickenResult result = run(cube, { .thickness = 0.5, .side = ThickenSide::out });
  expectSolid(result, "cube");
  EXPECT_EQ(result.folds.folded, 0U);
  for (std::size_t i = 0; i < cube.points.size(); ++i)
  {
    const Vec3& p = result.edit.mesh.points[i];
    const double largest =
      std::max({ std::abs(p.x - 2.0), std::abs(p.y - 2.0), std::abs(p.z - 2.0) });
    EXPECT_NEAR(largest, 2.5, 0.005);
  }
  EXPECT_NEAR(*describeMesh(result.edit.mesh).volume, 125.0 - 64.0, 0.3);
}

/// A corner with angles of 60, 90 and 90 degrees: the mean normal is not what moves the planes.
TEST(Thicken, KeepsThePlanesOfAPrismAtTheThickness)
{
  const double h = std::sqrt(0.75);
  const TriMesh prism{ { { 0, 0, 0 }, { 1, 0, 0 }, { 0.5, h, 0 }, { 0, 0, 2 }, { 1, 0, 2 },
                         { 0.5, h, 2 } },
    { { 0, 2, 1 }, { 3, 4, 5 }, { 0, 1, 4 }, { 0, 4, 3 }, { 1, 2, 5 }, { 1, 5, 4 }, { 2, 0, 3 },
      { 2, 3, 5 } } };
  constexpr double kThickness = 0.1;
  const ThickenResult result = run(prism, { .thickness = kThickness, .side = ThickenSide::out });
  for (std::size_t t = 0; t < prism.triangles.size(); ++t)
  {
    const auto& [a, b, c] = prism.triangles[t];
    const Vec3 p = prism.points[a];
    const Vec3 normal = unitVector(cross(prism.points[b] - p, prism.points[c] - p));
    for (const Index corner : result.edit.mesh.triangles[t])
    {
      const double height = dot(normal, result.edit.mesh.points[corner] - p);
      EXPECT_NEAR(
        height, kThickness, 0.13 * kThickness); // 2.24 times the thickness away is too far
    }
  }
}

TEST(Thicken, AnySurfaceBecomesAClosedManifold)
{
  for (const auto& [name, mesh] : surfaces())
  {
    for (const double thickness : { 1e-6, 0.05, 3.0 })
    {
      const ThickenResult result = run(mesh, { .thickness = thickness });
      if (result.edit.mesh.triangles.empty() || name == "flat triangle")
      {
        EXPECT_EQ(name, "flat triangle");
        continue;
      }
      expectSolid(result, name);
      EXPECT_TRUE(result.folds.folded > 0 || *describeMesh(result.edit.mesh).volume > 0.0) << name;
    }
  }
}

TEST(Thicken, ADiskGetsASphereAndARingATorus)
{
  EXPECT_EQ(describeMesh(run(corpus::square(), { .thickness = 0.1 }).edit.mesh).genus, 0);
  TriMesh ring = corpus::torus(12);
  std::erase_if(ring.triangles, [&](const Triangle& t) { return t[0] / 12 < 3; });
  const MeshReport report = describeMesh(run(ring, { .thickness = 0.1 }).edit.mesh);
  EXPECT_TRUE(report.isClosed);
  EXPECT_EQ(report.genus, 1);
  EXPECT_GT(*report.volume, 0.0);
}

TEST(Thicken, PointsStayWithinTheLimit)
{
  const std::uint64_t seed = pointSeed();
  for (auto [name, mesh] : surfaces())
  {
    Random random(seed);
    for (Vec3& p : mesh.points)
    {
      p = p + noise(random, 0.01) + Vec3{ 1e4, -1e5, 0.0 };
    }
    for (const double limit : { 1e-3, 0.07, 0.3 })
    {
      const ThickenResult result = run(mesh, { .thickness = 0.2, .maxDeviation = limit });
      double largest = 0.0;
      for (std::size_t i = 0; i < result.edit.mesh.points.size(); ++i)
      {
        largest = std::max(
          largest, length(result.edit.mesh.points[i] - mesh.points[result.edit.pointOrigin[i]]));
      }
      EXPECT_LE(largest, limit) << name << " SCAN_TEST_SEED=" << seed;
      EXPECT_TRUE(limit > 0.2 || result.heldBack > 0) << name;
      EXPECT_TRUE(limit < 0.2 || result.heldBack == 0) << name;
    }
  }
}

TEST(Thicken, LeavesTheRestAsItWas)
{
  const std::uint64_t seed = pointSeed();
  for (const auto& [name, mesh] : surfaces())
  {
    const std::vector<std::uint8_t> inRegion = corpus::randomRegion(mesh, seed);
    Execution execution(2);
    const ThickenResult result = thicken(mesh, inRegion, { .thickness = 0.05 }, execution);
    const SurfaceEdit& edit = result.edit;
    std::size_t place = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    {
      if (inRegion[t] == 0)
      {
        ASSERT_EQ(edit.triangleOrigin[place], t) << name << " SCAN_TEST_SEED=" << seed;
        for (std::size_t k = 0; k < 3; ++k)
        {
          const Index point = edit.mesh.triangles[place][k];
          EXPECT_EQ(edit.pointOrigin[point], mesh.triangles[t][k]) << name;
          EXPECT_EQ(edit.mesh.points[point], mesh.points[mesh.triangles[t][k]]) << name;
        }
        ++place;
      }
    }
    for (std::size_t i = place; i < edit.triangleOrigin.size(); ++i)
    {
      EXPECT_TRUE(edit.triangleOrigin[i] == kNone || inRegion[edit.triangleOrigin[i]] != 0) << name;
    }
    TriMesh solid = edit.mesh;
    solid.triangles.erase(
      solid.triangles.begin(), solid.triangles.begin() + static_cast<std::ptrdiff_t>(place));
    const MeshReport report = describeMesh(solid);
    EXPECT_TRUE(solid.triangles.empty() || name == "flat triangle" ||
      (report.isClosed && report.isManifold && report.isOriented))
      << name << " SCAN_TEST_SEED=" << seed;
  }
}

TEST(Thicken, BothCopiesComeFromThePointsOfTheSurface)
{
  TriMesh mesh = corpus::square();
  mesh.points.push_back({ 9, 9, 9 }); // used by no triangle: stays, once
  const SurfaceEdit edit = run(mesh, { .thickness = 0.5 }).edit;
  EXPECT_EQ(edit.pointOrigin, (std::vector<Index>{ 4, 0, 1, 2, 3, 0, 1, 2, 3 }));
  EXPECT_EQ(edit.mesh.points[0], mesh.points[4]);
  EXPECT_NEAR(edit.mesh.points[1].z, 0.25, 1e-9);
  EXPECT_NEAR(edit.mesh.points[5].z, -0.25, 1e-9);
  EXPECT_EQ(edit.triangleOrigin[0], 0U);
  EXPECT_EQ(edit.triangleOrigin[3], 1U);
  EXPECT_EQ(edit.triangleOrigin[4], kNone);
  EXPECT_EQ(edit.mesh.triangles.size(), 12U);
}

TEST(Thicken, AnEmptyRegionChangesNothing)
{
  const TriMesh mesh = corpus::torus(8);
  Execution execution(1);
  const std::vector<std::uint8_t> none(mesh.triangles.size(), 0);
  const SurfaceEdit edit = thicken(mesh, none, { .thickness = 1.0 }, execution).edit;
  EXPECT_EQ(edit.mesh.points, mesh.points);
  EXPECT_EQ(edit.mesh.triangles, mesh.triangles);
}

TEST(Thicken, IsTheSameOnAnyNumberOfThreads)
{
  const TriMesh mesh = corpus::midpoints(corpus::midpoints(corpus::torus(40)));
  const ThickenResult one = run(mesh, { .thickness = 0.9 }, 1);
  const ThickenResult three = run(mesh, { .thickness = 0.9 }, 3);
  EXPECT_EQ(one.edit.mesh.points, three.edit.mesh.points);
  EXPECT_EQ(one.edit.mesh.triangles, three.edit.mesh.triangles);
  EXPECT_EQ(one.folds.isFolded, three.folds.isFolded);
}

TEST(Thicken, RefusesAndStops)
{
  EXPECT_THROW(run(corpus::square(), { .thickness = 0.0 }), Error);
  EXPECT_THROW(run({ { { 0, 0, 0 } }, { { 0, 1, 2 } } }, { .thickness = 1.0 }), Error);
  TriMesh infinite = corpus::square();
  infinite.points[1].x = std::numeric_limits<double>::infinity();
  EXPECT_THROW(run(infinite, { .thickness = 1.0 }), Error);
  for (const char* const phase : { "thicken", "folds" })
  {
    const CancelToken token;
    Execution execution(2, token,
      [&](std::string_view now, double fraction)
      {
        if (now == phase && fraction > 0.0)
        {
          token.cancel();
        }
      });
    execution.plan({ { "thicken", 1.0 }, { "folds", 1.0 } });
    const TriMesh mesh = corpus::torus(20);
    EXPECT_THROW(thicken(mesh, allOf(mesh), { .thickness = 0.1 }, execution), Cancelled) << phase;
  }
}

} // namespace
} // namespace scan::test
