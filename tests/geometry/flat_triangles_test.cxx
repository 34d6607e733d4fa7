// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/flat_triangles.h"

#include "filters/geometry/mesh_checks.h"
#include "tests/geometry/mesh_corpus.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <string>

using namespace scan;

namespace
{

FlatRemoval withoutFlat(TriMesh mesh, double leastHeight = 0.0)
{
  Execution execution(2);
  return removeFlatTriangles(std::move(mesh), leastHeight, execution);
}

/// A square of two triangles whose diagonal has n points on it, which only flat triangles use.
TriMesh squareWithFlatFan(Index n)
{
  TriMesh mesh = corpus::square();
  std::vector<Index> line = { 0 };
  for (Index i = 1; i <= n; ++i)
  {
    const double t = i / double(n + 1);
    line.push_back(static_cast<Index>(mesh.points.size()));
    mesh.points.push_back({ t, t, 0 });
  }
  line.push_back(2);
  // the fan lies between the two triangles: their edge and its reverse
  for (std::size_t i = 1; i + 1 < line.size(); ++i)
  {
    mesh.triangles.push_back({ 0, line[i], line[i + 1] });
  }
  // the triangle below the diagonal has all the points
  mesh.triangles.erase(mesh.triangles.begin());
  for (std::size_t i = 0; i + 1 < line.size(); ++i)
  {
    mesh.triangles.push_back({ line[i + 1], line[i], 1 });
  }
  return mesh;
}

} // namespace

TEST(IsFlat, IsExact)
{
  EXPECT_TRUE(isFlat({ 0, 0, 0 }, { 1, 2, 3 }, { 2, 4, 6 }));
  EXPECT_TRUE(isFlat({ 1, 1, 1 }, { 1, 1, 1 }, { 2, 4, 6 }));
  EXPECT_FALSE(isFlat({ 0, 0, 0 }, { 1, 2, 3 }, { 2, 4, std::nextafter(6.0, 7.0) }));
  EXPECT_FALSE(isFlat({ 0, 0, 0 }, { 1e-170, 0, 0 }, { 0, 1e-170, 0 })); // products vanish
  // far away the points below are not on a line, though computed cross products may say so
  const Vec3 far = { 6e6, 5e6, 4e6 };
  EXPECT_FALSE(isFlat(far, far + Vec3{ 1, 1, 1 }, far + Vec3{ 2, 2, 2 + 1e-9 }));
  EXPECT_FALSE(isFlat({ 0, 0, 0 }, { 1, 0, 0 }, { std::nan(""), 0, 0 }));
}

TEST(RemoveFlatTriangles, LeavesOthersAlone)
{
  const TriMesh torus = corpus::torus(8);
  const FlatRemoval removal = withoutFlat(torus);
  EXPECT_EQ(removal.mesh.triangles, torus.triangles);
  EXPECT_EQ(removal.mesh.points, torus.points);
  EXPECT_EQ(removal.cut, 0U);
}

TEST(RemoveFlatTriangles, DropsThoseThatNameAPointTwice)
{
  TriMesh mesh = corpus::square();
  mesh.triangles.insert(mesh.triangles.begin(), { 3, 3, 1 });
  const FlatRemoval removal = withoutFlat(mesh);
  EXPECT_EQ(removal.mesh.triangles, corpus::square().triangles);
  EXPECT_EQ(removal.triangleOrigin, (std::vector<Index>{ 1, 2 }));
}

TEST(RemoveFlatTriangles, CutsTheNeighbourWhereACornerLiesOnItsEdge)
{
  // the third triangle is flat: 4 lies between 0 and 2
  TriMesh mesh = corpus::square();
  mesh.points.push_back({ 0.5, 0.5, 0 });
  mesh.triangles = { { 0, 1, 4 }, { 4, 1, 2 }, { 0, 4, 2 }, { 0, 2, 3 } };
  const FlatRemoval removal = withoutFlat(mesh);
  EXPECT_EQ(removal.mesh.triangles,
    (std::vector<Triangle>{ { 0, 1, 4 }, { 4, 1, 2 }, { 0, 4, 3 }, { 4, 2, 3 } }));
  EXPECT_EQ(removal.triangleOrigin, (std::vector<Index>{ 0, 1, 3, 3 }));
  EXPECT_EQ(removal.cut, 1U);
}

TEST(RemoveFlatTriangles, DissolvesLongFans)
{
  for (const Index n : { 1U, 2U, 7U, 1000U })
  {
    const FlatRemoval removal = withoutFlat(squareWithFlatFan(n));
    const MeshReport report = describeMesh(removal.mesh);
    EXPECT_EQ(report.flatTriangles + report.collapsedTriangles, 0U) << n;
    EXPECT_EQ(report.boundaryEdges, 4U) << n;
    EXPECT_TRUE(report.isManifold && report.isOriented) << n;
    EXPECT_NEAR(report.area, 1.0, 1e-12) << n;
  }
}

TEST(RemoveFlatTriangles, DissolvesZigzagStrips)
{
  // two fans whose borders have points on one line, by turns, and flat triangles between them
  for (const Index n : { 3U, 64U, 5000U })
  {
    TriMesh mesh{ { { 0, 0, 0 }, { 1, 0, 0 }, { 0.5, 1, 0 }, { 0.5, -1, 0 } }, {} };
    std::array<std::vector<Index>, 2> sides = { std::vector<Index>{ 0 }, { 0 } };
    for (Index i = 1; i < 2 * n; ++i)
    {
      sides[i % 2].push_back(static_cast<Index>(mesh.points.size()));
      mesh.points.push_back({ i / 16384.0, 0, 0 });
    }
    sides[0].push_back(1);
    sides[1].push_back(1);
    for (std::size_t i = 1; i < sides[0].size(); ++i)
    {
      mesh.triangles.push_back({ sides[0][i - 1], sides[0][i], 2 });
    }
    for (std::size_t i = 1; i < sides[1].size(); ++i)
    {
      mesh.triangles.push_back({ sides[1][i], sides[1][i - 1], 3 });
    }
    std::vector<Index> border = sides[1]; // along the lower side and back along the upper one
    border.insert(border.end(), sides[0].rbegin() + 1, sides[0].rend() - 1);
    for (std::size_t low = 0, top = border.size() - 1; low + 1 < top;)
    {
      mesh.triangles.push_back({ border[low], border[low + 1], border[top] });
      if (++low + 1 < top)
      {
        mesh.triangles.push_back({ border[low], border[top - 1], border[top] });
        --top;
      }
    }
    ASSERT_EQ(describeMesh(mesh).boundaryEdges, 4U);
    const FlatRemoval removal = withoutFlat(mesh);
    const MeshReport report = describeMesh(removal.mesh);
    EXPECT_EQ(report.flatTriangles + report.collapsedTriangles, 0U) << n;
    EXPECT_EQ(report.boundaryEdges, 4U) << n;
    EXPECT_TRUE(report.isManifold && report.isOriented) << n;
    EXPECT_NEAR(report.area, 1.0, 1e-12) << n;
    EXPECT_EQ(report.triangles, 4 * std::size_t{ n }) << n;
    EXPECT_GT(removal.cut, n);
  }
}

TEST(RemoveFlatTriangles, JoinsCornersInOnePlace)
{
  // a needle whose short side has no length, between two triangles
  TriMesh mesh = corpus::square();
  mesh.points.push_back(mesh.points[2]);
  mesh.triangles = { { 0, 1, 2 }, { 0, 2, 4 }, { 0, 4, 3 } };
  const FlatRemoval removal = withoutFlat(mesh);
  EXPECT_EQ(removal.mesh.triangles, corpus::square().triangles);
}

TEST(RemoveFlatTriangles, TakesLowOnesForFlatWhenAsked)
{
  TriMesh mesh = corpus::square();
  mesh.points.push_back({ 0.5, 0.5 + 1e-9, 0 }); // not quite on the diagonal
  mesh.points.push_back({ 1.0, 1e-10, 0 });      // not quite at a corner
  mesh.triangles = { { 0, 5, 4 }, { 4, 5, 2 }, { 0, 4, 2 }, { 0, 2, 3 }, { 0, 1, 5 } };
  EXPECT_EQ(withoutFlat(mesh).mesh.triangles, mesh.triangles);
  const FlatRemoval removal = withoutFlat(mesh, 1e-8);
  const MeshReport report = describeMesh(removal.mesh);
  EXPECT_EQ(report.triangles, 4U);
  EXPECT_EQ(report.boundaryEdges, 4U);
  EXPECT_TRUE(report.isManifold && report.isOriented);
  EXPECT_NEAR(report.area, 1.0, 1e-8);
}

TEST(RemoveFlatTriangles, EndsOnAnySoupWithATolerance)
{
  for (unsigned seed = 1; seed <= 20; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> coordinate(0.0, 1.0);
    TriMesh mesh;
    for (Index i = 0; i < 60; ++i)
    {
      mesh.points.push_back({ coordinate(random), coordinate(random), 0.05 * coordinate(random) });
    }
    for (Index i = 0; i < 200; ++i)
    {
      const auto corner = [&] { return static_cast<Index>(random() % 60); };
      mesh.triangles.push_back({ corner(), corner(), corner() });
    }
    withoutFlat(mesh, 0.1);
  }
}

TEST(RemoveFlatTriangles, CopesWithNothingElse)
{
  TriMesh mesh{ { { 0, 0, 0 }, { 1, 1, 1 }, { 2, 2, 2 }, { 3, 3, 3 }, { 3, 3, 3 } }, {} };
  for (Index a = 0; a < 5; ++a)
  {
    for (Index b = 0; b < 5; ++b)
    {
      for (Index c = 0; c < 5; ++c)
      {
        mesh.triangles.push_back({ a, b, c });
      }
    }
  }
  EXPECT_TRUE(withoutFlat(mesh).mesh.triangles.empty());
}
