// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/triangle_tree.h"

#include "filters/base/error.h"
#include "filters/geometry/point_triangle.h"
#include "tests/geometry/mesh_fixtures.h"
#include "tests/geometry/point_fixtures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace
{

using namespace scan;
using namespace scan::test;

/// The nearest place, found by looking at all triangles.
SurfacePlace nearestOfAll(const TriMesh& mesh, const Vec3& at)
{
  SurfacePlace best;
  for (Index t = 0; t < mesh.triangles.size(); ++t)
  {
    const auto& [a, b, c] = mesh.triangles[t];
    const Vec3 q = nearestPointOnTriangle(at, mesh.points[a], mesh.points[b], mesh.points[c]);
    if (const double squared = dot(q - at, q - at); squared < best.squaredDistance)
    {
      best = { t, q, squared };
    }
  }
  return best;
}

bool isSame(const SurfacePlace& a, const SurfacePlace& b)
{
  return a.triangle == b.triangle && a.point == b.point && a.squaredDistance == b.squaredDistance;
}

bool touches(const TriMesh& mesh, Index triangle, const Box& box)
{
  const auto touchesAlong = [&](auto axis)
  {
    const auto& [i, j, k] = mesh.triangles[triangle];
    const auto [low, high] =
      std::minmax({ mesh.points[i].*axis, mesh.points[j].*axis, mesh.points[k].*axis });
    return low <= box.high.*axis && high >= box.low.*axis;
  };
  return touchesAlong(&Vec3::x) && touchesAlong(&Vec3::y) && touchesAlong(&Vec3::z);
}

class TriangleTreeOfSoups : public testing::TestWithParam<int>
{
protected:
  void SetUp() override
  {
    SCOPED_TRACE("SCAN_TEST_SEED=" + std::to_string(pointSeed()));
    this->Mesh = meshes::soup(this->Numbers, 300, 400, GetParam());
  }

  Vec3 somewhere()
  {
    const double size = GetParam() > 0 ? 1.5 * GetParam() : 1.5;
    const double x = size * meshes::within1(this->Numbers);
    const double y = size * meshes::within1(this->Numbers);
    const Vec3 at{ x, y, size * meshes::within1(this->Numbers) };
    return GetParam() > 0 ? Vec3{ std::round(at.x), std::round(at.y), at.z } : at;
  }

  Random Numbers{ pointSeed() };
  TriMesh Mesh;
  Execution Run;
};

TEST_P(TriangleTreeOfSoups, NearestIsThatOfAllTrianglesWhateverTheHint)
{
  const TriangleTree tree(this->Mesh, this->Run);
  for (Index i = 0; i < 500; ++i)
  {
    const Vec3 at = this->somewhere();
    const SurfacePlace expected = nearestOfAll(this->Mesh, at);
    for (const Index hint : { kNone, i % 400, expected.triangle })
    {
      const SurfacePlace found = tree.nearest(at, hint);
      ASSERT_TRUE(isSame(found, expected))
        << found.triangle << " at " << found.squaredDistance << ", but " << expected.triangle
        << " at " << expected.squaredDistance << " SCAN_TEST_SEED=" << pointSeed();
    }
  }
}

TEST_P(TriangleTreeOfSoups, TheTrianglesNearABoxAnswerAsAllDo)
{
  const TriangleTree tree(this->Mesh, this->Run);
  TrianglesNear near(tree);
  for (int i = 0; i < 50; ++i)
  {
    const Vec3 low = this->somewhere();
    const double size = std::ldexp(1.0, -i % 8);
    near.moveTo({ low, low + Vec3{ size, size, size } }, 0.1 * (i % 10));
    for (int j = 0; j < 10; ++j)
    {
      // some out of the box
      const Vec3 at = low + Vec3{ size, 1.2 * size, size } * this->Numbers.unit();
      ASSERT_TRUE(isSame(near.nearest(at, kNone), tree.nearest(at)))
        << "SCAN_TEST_SEED=" << pointSeed();
    }
  }
}

TEST_P(TriangleTreeOfSoups, TouchingFindsAllBoxesThatTouchABox)
{
  const TriangleTree tree(this->Mesh, this->Run);
  for (int i = 0; i < 100; ++i)
  {
    const Vec3 low = this->somewhere();
    const Box box{ low, low + Vec3{ 0.5, 0.25, 1.0 } };
    std::vector<Index> found;
    tree.touching(box, found);
    std::ranges::sort(found);
    std::vector<Index> expected;
    for (Index t = 0; t < this->Mesh.triangles.size(); ++t)
    {
      if (touches(this->Mesh, t, box))
      {
        expected.push_back(t);
      }
    }
    ASSERT_EQ(found, expected) << "SCAN_TEST_SEED=" << pointSeed();
  }
}

INSTANTIATE_TEST_SUITE_P(Grids, TriangleTreeOfSoups, testing::Values(0, 2, 6));

TEST(TriangleTree, AnswersOfOneAndManyThreadsAreTheSame)
{
  const TriMesh mesh = meshes::sphere(100, 3.0);
  Execution one(1);
  Execution four(4);
  const TriangleTree first(mesh, one);
  const TriangleTree second(mesh, four);
  Random random(pointSeed());
  for (int i = 0; i < 2000; ++i)
  {
    const Vec3 at = noise(random, 2.0);
    ASSERT_TRUE(isSame(first.nearest(at), second.nearest(at)));
  }
}

TEST(TriangleTree, OfEquallyNearTrianglesTheFirstIsTheAnswer)
{
  TriMesh mesh = meshes::ground(4, [](double, double) { return 0.0; });
  meshes::add(mesh, mesh);
  Execution run;
  const TriangleTree tree(mesh, run);
  for (Index hint = 0; hint < mesh.triangles.size(); ++hint)
  {
    EXPECT_LT(tree.nearest({ 0.5, 0.5, 1.0 }, hint).triangle, 32U);
    EXPECT_EQ(
      tree.nearest({ 0.1, 0.05, 1.0 }, hint).triangle, tree.nearest({ 0.1, 0.05, 1.0 }).triangle);
  }
}

TEST(TriangleTree, ATriangleThatIsHardlyOneIsAsFarAsItsLongestEdge)
{
  Random random(pointSeed());
  Execution run;
  for (int i = 0; i < 2000; ++i)
  {
    // rounding turns the normal of such a triangle anywhere
    const Vec3 a = noise(random, 1.0);
    const Vec3 b = noise(random, 1.0);
    const Vec3 at = noise(random, 1.0);
    const Vec3 between = a + (b - a) * random.unit();
    const TriMesh sliver{ { a, b, between }, { { 0, 1, 2 } } };
    const TriMesh edge{ { a, b }, { { 0, 1, 1 } } };
    EXPECT_NEAR(TriangleTree(sliver, run).nearest(at).squaredDistance,
      TriangleTree(edge, run).nearest(at).squaredDistance, 1e-12)
      << "SCAN_TEST_SEED=" << pointSeed();
  }
}

TEST(TriangleTree, ManagesExtremeCoordinates)
{
  TriMesh mesh = meshes::sphere(10, 1.0, { 4e6, 5e6, 100.0 });
  mesh.points.push_back({ 1e30, 1e30, 1e30 });
  mesh.triangles.push_back({ 0, 1, static_cast<Index>(mesh.points.size() - 1) });
  Execution run;
  const TriangleTree tree(mesh, run);
  EXPECT_NEAR(std::sqrt(tree.nearest({ 4e6, 5e6, 97.0 }).squaredDistance), 2.0, 1e-6);
  EXPECT_EQ(
    tree.nearest({ 4e6, 5e6, 97.0 }).triangle, nearestOfAll(mesh, { 4e6, 5e6, 97.0 }).triangle);
  EXPECT_NE(tree.nearest({ 1e300, 0, 0 }).triangle, kNone);
}

TEST(TriangleTree, WithoutTrianglesNothingIsNear)
{
  const TriMesh mesh{ { { 0, 0, 0 } }, {} };
  Execution run;
  const TriangleTree tree(mesh, run);
  EXPECT_EQ(tree.nearest({ 0, 0, 0 }, 3).triangle, kNone);
  std::vector<Index> found;
  tree.touching({ { -1, -1, -1 }, { 1, 1, 1 } }, found);
  EXPECT_TRUE(found.empty());
}

TEST(TriangleTree, RefusesMissingCornersAndThoseThatAreNotFinite)
{
  Execution run;
  const TriMesh missing{ { { 0, 0, 0 }, { 1, 0, 0 } }, { { 0, 1, 2 } } };
  EXPECT_THROW(TriangleTree(missing, run), Error);
  const TriMesh notFinite{ { { 0, 0, 0 }, { 1, 0, 0 },
                             { 0, std::numeric_limits<double>::quiet_NaN(), 0 } },
    { { 0, 1, 2 } } };
  EXPECT_THROW(TriangleTree(notFinite, run), Error);
}

} // namespace
