// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/sharpen.h"

#include "filters/base/error.h"
#include "filters/geometry/point_triangle.h"
#include "filters/geometry/self_intersections.h"
#include "filters/geometry/wrap.h"
#include "tests/geometry/point_fixtures.h"
#include "tests/geometry/surface_corpus.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
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

SharpenResult run(const TriMesh& mesh, const SharpenOptions& options = {}, unsigned threads = 2)
{
  Execution execution(threads);
  return sharpen(mesh, allOf(mesh), options, execution);
}

/// The wrap of points on the sides of the cube [-1, 1]³, n × n a side, half a step off its edges.
/// @param shake of each point in its side, in steps
TriMesh sampledCube(int n, double shake, std::uint64_t seed)
{
  Random random(seed);
  std::vector<Vec3> points;
  const double step = 2.0 / n;
  for (int side = 0; side < 6; ++side)
  {
    for (int i = 0; i < n * n; ++i)
    {
      const auto place = [&](int k)
      { return step * (k + 0.5 + shake * (2.0 * random.unit() - 1.0)) - 1.0; };
      const double u = place(i % n);
      const double v = place(i / n);
      const double w = side % 2 == 0 ? -1.0 : 1.0;
      points.push_back(side / 2 == 0 ? Vec3{ w, u, v }
          : side / 2 == 1            ? Vec3{ u, w, v }
                                     : Vec3{ u, v, w });
    }
  }
  Execution execution(2);
  return wrap(points, {}, execution).surface;
}

/// Mean and largest distance of places on the edges of the cube from the surface.
std::pair<double, double> distanceOfEdges(const TriMesh& mesh)
{
  double sum = 0.0;
  double largest = 0.0;
  int count = 0;
  for (int edge = 0; edge < 12; ++edge)
  {
    for (int i = -10; i <= 10; ++i)
    {
      const double u = edge % 2 == 0 ? -1.0 : 1.0;
      const double v = edge / 2 % 2 == 0 ? -1.0 : 1.0;
      const double w = i / 10.0;
      const Vec3 at = edge / 4 == 0 ? Vec3{ w, u, v }
        : edge / 4 == 1             ? Vec3{ u, w, v }
                                    : Vec3{ u, v, w };
      double least = std::numeric_limits<double>::infinity();
      for (const auto& [a, b, c] : mesh.triangles)
      {
        least =
          std::min(least, squaredDistance(at, mesh.points[a], mesh.points[b], mesh.points[c]));
      }
      sum += std::sqrt(least);
      largest = std::max(largest, std::sqrt(least));
      ++count;
    }
  }
  return { sum / count, largest };
}

void expectSameKind(const TriMesh& before, const SharpenResult& result, const std::string& name)
{
  const MeshReport was = describeMesh(before);
  const MeshReport is = describeMesh(result.edit.mesh);
  EXPECT_EQ(is.isManifold, was.isManifold) << name;
  EXPECT_EQ(is.isClosed, was.isClosed) << name;
  EXPECT_EQ(is.isOriented, was.isOriented) << name;
  EXPECT_EQ(is.genus, was.genus) << name;
  EXPECT_EQ(is.boundaryLoops, was.boundaryLoops) << name;
  EXPECT_EQ(result.edit.pointOrigin.size(), result.edit.mesh.points.size()) << name;
  EXPECT_EQ(result.edit.triangleOrigin.size(), result.edit.mesh.triangles.size()) << name;
  EXPECT_EQ(result.edit.blends.size(),
    static_cast<std::size_t>(std::ranges::count(result.edit.pointOrigin, kNone)))
    << name;
}

TEST(Sharpen, GivesACubeItsEdgesBack)
{
  for (const int n : { 4, 11, 20 })
  {
    const TriMesh cube = sampledCube(n, 0.0, 1);
    const SharpenResult result = run(cube);
    expectSameKind(cube, result, "cube");
    const auto [mean, largest] = distanceOfEdges(cube);
    const auto [meanAfter, largestAfter] = distanceOfEdges(result.edit.mesh);
    const MeshReport report = describeMesh(result.edit.mesh);
    std::cout << n << " points a side: " << result.edges << " edges, " << result.corners
              << " corners, left out " << result.leftOut << ", distance of the edges: mean " << mean
              << " -> " << meanAfter << ", largest " << largest << " -> " << largestAfter
              << ", volume " << *describeMesh(cube).volume << " -> " << *report.volume << "\n";
    EXPECT_TRUE(report.isClosed && report.isManifold);
    EXPECT_EQ(report.genus, 0);
    EXPECT_EQ(result.corners, 8U);
    EXPECT_LT(meanAfter, 0.1 * mean);
    EXPECT_LT(largestAfter, 0.1 * largest);
    EXPECT_NEAR(*report.volume, 8.0, 1e-6);
    Execution execution(2);
    EXPECT_TRUE(selfIntersections(result.edit.mesh, execution).empty());
  }
}

TEST(Sharpen, GivesAShakenCubeMostOfItsEdgesBack)
{
  const std::uint64_t seed = pointSeed();
  const TriMesh cube = sampledCube(16, 0.3, seed);
  const SharpenResult result = run(cube);
  expectSameKind(cube, result, "cube");
  const auto [mean, largest] = distanceOfEdges(cube);
  const auto [meanAfter, largestAfter] = distanceOfEdges(result.edit.mesh);
  std::cout << "shaken: " << result.edges << " edges, " << result.corners << " corners, left out "
            << result.leftOut << ", distance of the edges: mean " << mean << " -> " << meanAfter
            << ", largest " << largest << " -> " << largestAfter << "\n";
  EXPECT_LT(meanAfter, 0.4 * mean) << "SCAN_TEST_SEED=" << seed;
  Execution execution(2);
  EXPECT_TRUE(selfIntersections(result.edit.mesh, execution).empty()) << seed;
}

/// Two square sides of n × n points that would meet at x = z = 0 at an angle, and the strip.
TriMesh bevelledWedge(Index n, double angle)
{
  TriMesh mesh;
  for (Index i = 0; i < 2 * n; ++i)
  {
    const double along = i < n ? n - 0.5 - i : i - n + 0.5;
    const Vec3 way = i < n ? Vec3{ 1, 0, 0 } : Vec3{ std::cos(angle), 0, std::sin(angle) };
    for (Index j = 0; j < n; ++j)
    {
      mesh.points.push_back(way * along + Vec3{ 0.0, double(j), 0.0 });
      if (i > 0 && j > 0)
      {
        const Index at = i * n + j;
        mesh.triangles.push_back({ at, at - n, at - n - 1 });
        mesh.triangles.push_back({ at, at - n - 1, at - 1 });
      }
    }
  }
  return mesh;
}

TEST(Sharpen, MeetsPlanesAtAnyAngleThatIsNotTooSharp)
{
  for (const double degrees : { 15.0, 40.0, 60.0, 90.0, 120.0, 240.0, 300.0 })
  {
    const TriMesh wedge = bevelledWedge(6, degrees * std::numbers::pi / 180.0);
    const SharpenResult result = run(wedge);
    expectSameKind(wedge, result, "wedge");
    EXPECT_EQ(result.edges, degrees < 50.0 ? 0U : 11U) << degrees;
    EXPECT_EQ(result.leftOut, degrees < 50.0 ? 11U : 0U) << degrees;
    for (std::size_t i = wedge.points.size(); i < result.edit.mesh.points.size(); ++i)
    {
      const Vec3& p = result.edit.mesh.points[i];
      EXPECT_LT(std::hypot(p.x, p.z), 1e-12) << degrees;
    }
  }
}

/// Whatever looks like a chamfer there.
TEST(Sharpen, MakesNoCrossingsOnNoisySurfaces)
{
  const std::uint64_t seed = pointSeed();
  Execution execution(2);
  Index cut = 0;
  for (std::uint64_t i = 0; i < 24; ++i)
  {
    Random random(seed + i);
    TriMesh mesh = sampledCube(8, 0.5, seed + i);
    std::ranges::for_each(
      mesh.points, [&](Vec3& p) { p = p + noise(random, 0.004 * double(i % 8)); });
    if (!selfIntersections(mesh, execution).empty())
    {
      continue;
    }
    const SharpenResult result = run(mesh, { .angle = 25.0 });
    cut += result.edges;
    expectSameKind(mesh, result, "noise");
    EXPECT_TRUE(selfIntersections(result.edit.mesh, execution).empty())
      << "SCAN_TEST_SEED=" << seed + i;
  }
  EXPECT_GT(cut, 100U);
}

TEST(Sharpen, LeavesWhatIsSmoothOrSharp)
{
  for (const TriMesh& mesh : { corpus::sphere(4), corpus::cube(4), corpus::monkeySaddle(20, 0.5) })
  {
    const SharpenResult result = run(mesh);
    EXPECT_EQ(result.edges + result.corners, 0U);
    EXPECT_EQ(result.edit.mesh.points, mesh.points);
    EXPECT_EQ(result.edit.mesh.triangles, mesh.triangles);
  }
}

TEST(Sharpen, KeepsPointsAndWhatASurfaceIs)
{
  for (const auto& [name, mesh] : surfaces())
  {
    Execution execution(2);
    const bool isClean = selfIntersections(mesh, execution).empty();
    for (const double angle : { 1.0, 5.0, 20.0, 60.0 })
    {
      const SharpenResult result = run(mesh, { .angle = angle });
      expectSameKind(mesh, result, name);
      ASSERT_TRUE(
        std::equal(mesh.points.begin(), mesh.points.end(), result.edit.mesh.points.begin()));
      EXPECT_TRUE(!isClean || selfIntersections(result.edit.mesh, execution).empty()) << name;
    }
  }
}

TEST(Sharpen, StaysWithinTheLimit)
{
  const TriMesh cube = sampledCube(8, 0.2, 1);
  for (const double limit : { 1e-4, 0.02, 1.0 })
  {
    const SharpenResult result = run(cube, { .maxDeviation = limit });
    for (std::size_t i = cube.points.size(); i < result.edit.mesh.points.size(); ++i)
    {
      const PointBlend& blend = result.edit.blends[i - cube.points.size()];
      Vec3 middle;
      for (std::size_t k = 0; k < 3; ++k)
      {
        middle = middle + cube.points[blend.from[k]] * blend.weights[k];
      }
      EXPECT_LE(length(result.edit.mesh.points[i] - middle), limit * (1.0 + 1e-12));
    }
    EXPECT_EQ(result.heldBack > 0, limit < 1.0);
    EXPECT_GT(result.edges, 100U);
  }
}

TEST(Sharpen, ChangesTheRegionOnly)
{
  const TriMesh cube = sampledCube(10, 0.1, 2);
  std::vector<std::uint8_t> inRegion;
  for (const auto& [a, b, c] : cube.triangles)
  {
    inRegion.push_back(cube.points[a].z + cube.points[b].z + cube.points[c].z > 0.1 ? 1 : 0);
  }
  Execution execution(2);
  const SharpenResult result = sharpen(cube, inRegion, {}, execution);
  EXPECT_GT(result.corners, 2U);
  expectSameKind(cube, result, "cube");
  std::set<Triangle> left(result.edit.mesh.triangles.begin(), result.edit.mesh.triangles.end());
  for (std::size_t t = 0; t < cube.triangles.size(); ++t)
  {
    EXPECT_TRUE(inRegion[t] != 0 || left.contains(cube.triangles[t]));
  }
  for (std::size_t i = cube.points.size(); i < result.edit.mesh.points.size(); ++i)
  {
    EXPECT_GT(result.edit.mesh.points[i].z, -0.5);
  }
}

TEST(Sharpen, IsTheSameOnAnyNumberOfThreads)
{
  const TriMesh cube = sampledCube(20, 0.3, 3);
  const SurfaceEdit one = run(cube, {}, 1).edit;
  const SurfaceEdit three = run(cube, {}, 3).edit;
  EXPECT_EQ(one.mesh.points, three.mesh.points);
  EXPECT_EQ(one.mesh.triangles, three.mesh.triangles);
}

TEST(Sharpen, RefusesAndStops)
{
  EXPECT_THROW(run({ { { 0, 0, 0 } }, { { 0, 1, 2 } } }), Error);
  const TriMesh cube = sampledCube(6, 0.0, 1);
  for (const char* const phase : { "sharpen", "check" })
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
    execution.plan({ { "sharpen", 1.0 }, { "check", 1.0 } });
    EXPECT_THROW(sharpen(cube, allOf(cube), {}, execution), Cancelled) << phase;
  }
}

} // namespace
} // namespace scan::test
