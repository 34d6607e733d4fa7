// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/offset.h"

#include "filters/base/error.h"
#include "tests/geometry/point_fixtures.h"
#include "tests/geometry/surface_corpus.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>

namespace scan::test
{
namespace
{

using corpus::surfaces;

OffsetResult run(const TriMesh& mesh, const OffsetOptions& options, unsigned threads = 2)
{
  Execution execution(threads);
  return offset(mesh, everywhere(mesh.points), options, execution);
}

TEST(Offset, GrowsAndShrinksASphere)
{
  const TriMesh sphere = corpus::sphere(5);
  for (const double distance : { 0.3, -0.3, 2.0 })
  {
    const OffsetResult result = run(sphere, { .distance = distance });
    EXPECT_EQ(result.folds.folded, 0U);
    EXPECT_EQ(result.moved, sphere.points.size());
    for (const Vec3& p : result.edit.mesh.points)
    {
      EXPECT_NEAR(length(p) - 1.0, distance, 0.005 * std::abs(distance));
    }
  }
}

TEST(Offset, MovesThePlanesOfACubeWithItsEdgesAndCorners)
{
  const TriMesh cube = corpus::cube(4);
  for (const double distance : { 0.5, -0.5 })
  {
    const OffsetResult result = run(cube, { .distance = distance });
    EXPECT_EQ(result.folds.folded, 0U);
    const double side = 4.0 + 2.0 * distance;
    EXPECT_NEAR(*describeMesh(result.edit.mesh).volume, side * side * side, 0.005 * side * side);
  }
}

TEST(Offset, GoesOutwardsWhereTrianglesFaceTheWrongWay)
{
  TriMesh sphere = corpus::sphere(3);
  for (std::size_t t = 0; t < sphere.triangles.size(); t += 5)
  {
    std::swap(sphere.triangles[t][0], sphere.triangles[t][1]);
  }
  const OffsetResult result = run(sphere, { .distance = 0.5 });
  EXPECT_EQ(result.edit.mesh.triangles, sphere.triangles);
  for (const Vec3& p : result.edit.mesh.points)
  {
    EXPECT_NEAR(length(p), 1.5, 0.02);
  }
}

TEST(Offset, TellsWhereItFolds)
{
  const TriMesh torus = corpus::torus(40); // the tube has radius 1, the hole too
  EXPECT_EQ(run(torus, { .distance = -0.7 }).folds.folded, 0U);
  EXPECT_EQ(run(torus, { .distance = 0.7 }).folds.folded, 0U);
  const SurfaceFolds through = run(torus, { .distance = -1.5 }).folds;
  EXPECT_GT(through.turned, torus.triangles.size() / 2);
  const OffsetResult filled = run(torus, { .distance = 1.2 }); // the hole closes
  EXPECT_GT(filled.folds.crossing, 0U);
  ASSERT_FALSE(filled.folds.places.empty());
  const Vec3& at = filled.folds.places.front();
  EXPECT_LT(std::hypot(at.x, at.y), 1.0);
  for (std::size_t t = 0; t < torus.triangles.size(); ++t)
  {
    const Vec3& was = torus.points[torus.triangles[t][0]];
    EXPECT_TRUE(filled.folds.isFolded[t] == 0 || std::hypot(was.x, was.y) < 2.0);
  }
}

TEST(Offset, StaysWithinTheLimitAndTheRegion)
{
  const std::uint64_t seed = pointSeed();
  for (auto [name, mesh] : surfaces())
  {
    Random random(seed);
    std::vector<std::uint8_t> inRegion;
    for (Vec3& p : mesh.points)
    {
      p = p + noise(random, 0.02) + Vec3{ 1e5, 0.0, -1e4 };
      inRegion.push_back(random.below(4) == 0 ? 0 : 1);
    }
    for (const double limit : { 0.01, 0.2, 9.0 })
    {
      Execution execution(2);
      const OffsetResult result =
        offset(mesh, inRegion, { .distance = -0.3, .maxDeviation = limit }, execution);
      EXPECT_EQ(result.edit.mesh.triangles, mesh.triangles) << name;
      for (std::size_t i = 0; i < mesh.points.size(); ++i)
      {
        const double shift = length(result.edit.mesh.points[i] - mesh.points[i]);
        EXPECT_LE(shift, std::min(limit, 0.3 * 2.0 + 1e-9)) << name << " SCAN_TEST_SEED=" << seed;
        EXPECT_TRUE(inRegion[i] != 0 || shift == 0.0) << name << " SCAN_TEST_SEED=" << seed;
      }
      EXPECT_TRUE(limit < 9.0 || result.heldBack == 0) << name;
    }
  }
}

TEST(Offset, IsTheSameOnAnyNumberOfThreads)
{
  const TriMesh mesh = corpus::midpoints(corpus::torus(60));
  const OffsetResult one = run(mesh, { .distance = -0.9 }, 1);
  const OffsetResult three = run(mesh, { .distance = -0.9 }, 3);
  EXPECT_EQ(one.edit.mesh.points, three.edit.mesh.points);
  EXPECT_EQ(one.folds.isFolded, three.folds.isFolded);
}

TEST(Offset, RefusesAndStops)
{
  EXPECT_THROW(run({ { { 0, 0, 0 } }, { { 0, 1, 2 } } }, { .distance = 1.0 }), Error);
  TriMesh infinite = corpus::square();
  infinite.points[1].x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(run(infinite, { .distance = 1.0 }), Error);
  for (const char* const phase : { "offset", "folds" })
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
    execution.plan({ { "offset", 1.0 }, { "folds", 1.0 } });
    const TriMesh mesh = corpus::torus(20);
    EXPECT_THROW(offset(mesh, everywhere(mesh.points), { .distance = 0.1 }, execution), Cancelled)
      << phase;
  }
}

} // namespace
} // namespace scan::test
