// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/mesh_split.h"

#include "filters/geometry/mesh_checks.h"
#include "tests/geometry/mesh_corpus.h"

#include <gtest/gtest.h>

#include <random>

using namespace scan;

namespace
{

SplitResult splitUp(TriMesh mesh)
{
  Execution execution(2);
  return splitNonManifold(std::move(mesh), execution);
}

/// What the header promises for every input.
void expectFaithful(const TriMesh& input, const SplitResult& split)
{
  ASSERT_EQ(split.mesh.triangles.size(), input.triangles.size());
  ASSERT_EQ(split.pointOrigin.size(), split.mesh.points.size());
  for (std::size_t t = 0; t < input.triangles.size(); ++t)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      ASSERT_EQ(split.pointOrigin[split.mesh.triangles[t][k]], input.triangles[t][k]);
    }
  }
  for (std::size_t p = 0; p < split.mesh.points.size(); ++p)
  {
    ASSERT_TRUE(split.mesh.points[p] == input.points[split.pointOrigin[p]]);
    ASSERT_TRUE(p >= input.points.size() || split.pointOrigin[p] == p);
  }
  const MeshReport report = describeMesh(split.mesh);
  EXPECT_TRUE(report.isManifold) << report.nonManifoldEdges << ' ' << report.nonManifoldVertices;
  EXPECT_TRUE(report.isOriented);
  EXPECT_EQ(split.mate, pairEdges(split.mesh).mate);
}

} // namespace

TEST(MeshSplit, LeavesAManifoldAlone)
{
  const TriMesh torus = corpus::torus(8);
  const SplitResult split = splitUp(torus);
  EXPECT_EQ(split.mesh.triangles, torus.triangles);
  EXPECT_EQ(split.mesh.points, torus.points);
  EXPECT_EQ(split.edgesSplit + split.verticesSplit, 0U);
}

TEST(MeshSplit, PartsTetrahedraOnOneEdge)
{
  const TriMesh mesh = corpus::tetrahedraOnOneEdge();
  const SplitResult split = splitUp(mesh);
  expectFaithful(mesh, split);
  EXPECT_EQ(split.edgesSplit, 1U);
  EXPECT_EQ(split.verticesSplit, 2U);
  const MeshReport report = describeMesh(split.mesh);
  EXPECT_TRUE(report.isClosed);
  EXPECT_EQ(report.components.size(), 2U); // by the solids, not across the gap between them
  EXPECT_EQ(report.genus, 0);
}

TEST(MeshSplit, PartsTetrahedraOnOnePoint)
{
  const TriMesh mesh = corpus::tetrahedraOnOnePoint();
  const SplitResult split = splitUp(mesh);
  expectFaithful(mesh, split);
  EXPECT_EQ(split.edgesSplit, 0U);
  EXPECT_EQ(split.verticesSplit, 1U);
  EXPECT_TRUE(describeMesh(split.mesh).isClosed);
}

TEST(MeshSplit, FinOnASolidBecomesBoundaryAndTheSolidStaysClosed)
{
  TriMesh mesh = corpus::tetrahedron();
  mesh.points.push_back({ -1, -1, 0 });
  mesh.triangles.push_back({ 0, 1, 4 });
  const SplitResult split = splitUp(mesh);
  expectFaithful(mesh, split);
  EXPECT_EQ(describeMesh(split.mesh).boundaryEdges, 3U);
}

TEST(MeshSplit, OpensAMoebiusStripAtItsTwist)
{
  const TriMesh mesh = corpus::moebius();
  const SplitResult split = splitUp(mesh);
  expectFaithful(mesh, split);
  EXPECT_EQ(split.edgesSplit, describeMesh(mesh).misorientedEdges);
}

TEST(MeshSplit, FlippedTriangleBecomesAnIsland)
{
  TriMesh mesh = corpus::torus(8);
  std::swap(mesh.triangles[5][0], mesh.triangles[5][1]);
  const SplitResult split = splitUp(mesh);
  expectFaithful(mesh, split);
  EXPECT_EQ(split.edgesSplit, 3U);
  EXPECT_EQ(describeMesh(split.mesh).components.size(), 2U);
}

TEST(MeshSplit, DuplicateTrianglesLeaveTheSolidWhole)
{
  TriMesh mesh = corpus::tetrahedron();
  mesh.triangles.push_back(mesh.triangles[0]);
  mesh.triangles.push_back({ mesh.triangles[0][1], mesh.triangles[0][0], mesh.triangles[0][2] });
  const SplitResult split = splitUp(mesh);
  expectFaithful(mesh, split);
  EXPECT_TRUE(describeMesh(split.mesh).isClosed); // balanced in, closed out
}

TEST(MeshSplit, KeepsUnusedPointsAndTakesAnEmptyMesh)
{
  EXPECT_EQ(splitUp({ { { 1, 2, 3 } }, {} }).mesh.points.size(), 1U);
  EXPECT_TRUE(splitUp({}).mesh.points.empty());
}

// Two cubes diagonal to each other between two full layers touch along one edge. The solid is
// whole at both ends of that edge, so neither can tell the two sheets apart: they swap partners,
// which joins the cubes through the edge and leaves two dents.
TEST(MeshSplit, JoinsThroughAnEdgeThatCannotBeParted)
{
  const TriMesh mesh = corpus::voxelBorder(
    3, [](Index i, Index j, Index k) { return i < 2 && j < 2 && (k != 1 || i == j); });
  const SplitResult split = splitUp(mesh);
  expectFaithful(mesh, split);
  EXPECT_EQ(split.edgesSplit, 1U);
  EXPECT_EQ(split.verticesSplit, 2U);
  const MeshReport report = describeMesh(split.mesh);
  EXPECT_TRUE(report.isClosed);
  EXPECT_EQ(report.genus, 0);
  EXPECT_EQ(report.volume, 10.0);
}

TEST(MeshSplit, BorderOfAnySolidStaysClosedWithItsVolume)
{
  for (unsigned seed = 1; seed <= 60; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    std::vector<bool> solid(6 * 6 * 6);
    for (std::size_t i = 0; i < solid.size(); ++i)
    {
      solid[i] = random() % 100 < 20 + seed;
    }
    const TriMesh mesh =
      corpus::voxelBorder(6, [&](Index i, Index j, Index k) { return solid[i + 6 * j + 36 * k]; });
    const SplitResult split = splitUp(mesh);
    expectFaithful(mesh, split);
    const MeshReport report = describeMesh(split.mesh);
    EXPECT_TRUE(report.isClosed);
    EXPECT_EQ(report.volume.value(), double(std::count(solid.begin(), solid.end(), true)));
  }
}

TEST(MeshSplit, AnyTriangleSoupComesOutManifold)
{
  for (unsigned seed = 1; seed <= 200; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    TriMesh mesh;
    const Index points = 4 + random() % 8;
    for (Index p = 0; p < points; ++p) // a coarse lattice: many collinear and coincident points
    {
      mesh.points.push_back({ double(random() % 3), double(random() % 3), double(random() % 3) });
    }
    for (unsigned t = 0; t < 10 + seed % 90; ++t)
    {
      const Index a = static_cast<Index>(random() % points);
      const Index b = (a + 1 + static_cast<Index>(random() % (points - 1))) % points;
      Index c = static_cast<Index>(random() % points);
      while (c == a || c == b)
      {
        c = (c + 1) % points;
      }
      mesh.triangles.push_back({ a, b, c });
    }
    expectFaithful(mesh, splitUp(mesh));
  }
}

TEST(MeshSplit, CollapsedTriangleBecomesAnIsland)
{
  TriMesh mesh = corpus::tetrahedron();
  mesh.triangles.push_back({ 0, 0, 1 });
  const SplitResult split = splitUp(mesh);
  const Triangle& island = split.mesh.triangles.back();
  EXPECT_NE(island[0], island[1]);
  EXPECT_EQ(describeMesh(split.mesh).boundaryEdges, 3U);
  EXPECT_TRUE(describeMesh(split.mesh).isManifold);
}
