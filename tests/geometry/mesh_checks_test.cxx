// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/mesh_checks.h"

#include "filters/base/error.h"
#include "tests/geometry/mesh_corpus.h"

#include <gtest/gtest.h>

#include <numbers>

using namespace scan;

TEST(MeshChecks, TetrahedronIsAClosedSphere)
{
  const MeshReport report = describeMesh(corpus::tetrahedron());
  EXPECT_EQ(report.points, 4U);
  EXPECT_EQ(report.pointsUsed, 4U);
  EXPECT_EQ(report.triangles, 4U);
  EXPECT_EQ(report.edges, 6U);
  EXPECT_TRUE(report.isClosed && report.isManifold && report.isOriented);
  EXPECT_EQ(report.eulerCharacteristic, 2);
  EXPECT_EQ(report.genus, 0);
  EXPECT_NEAR(report.volume.value(), 1.0 / 3.0, 1e-15);
  EXPECT_NEAR(report.area, 2.0 * std::numbers::sqrt3, 1e-15);
  EXPECT_NEAR(report.shortestEdge, std::numbers::sqrt2, 1e-15);
  EXPECT_NEAR(report.meanEdge, std::numbers::sqrt2, 1e-15);
  EXPECT_NEAR(report.boxDiagonal, std::numbers::sqrt3, 1e-15);
}

TEST(MeshChecks, InsideOutHasNegativeVolume)
{
  TriMesh mesh = corpus::tetrahedron();
  for (Triangle& corner : mesh.triangles)
  {
    std::swap(corner[0], corner[1]);
  }
  EXPECT_NEAR(describeMesh(mesh).volume.value(), -1.0 / 3.0, 1e-15);
}

TEST(MeshChecks, OpenDiskHasOneBoundaryLoopAndNoVolume)
{
  const MeshReport report = describeMesh(corpus::square());
  EXPECT_FALSE(report.isClosed);
  EXPECT_TRUE(report.isManifold && report.isOriented);
  EXPECT_EQ(report.boundaryEdges, 4U);
  EXPECT_EQ(report.boundaryLoops, 1U);
  EXPECT_EQ(report.eulerCharacteristic, 1);
  EXPECT_EQ(report.genus, 0);
  EXPECT_FALSE(report.volume.has_value());
}

TEST(MeshChecks, TorusHasGenusOneAndTheVolumeOfItsPolygon)
{
  const MeshReport report = describeMesh(corpus::torus(64));
  EXPECT_TRUE(report.isClosed && report.isManifold && report.isOriented);
  EXPECT_EQ(report.eulerCharacteristic, 0);
  EXPECT_EQ(report.genus, 1);
  const double smooth = 4.0 * std::numbers::pi * std::numbers::pi; // 2 pi^2 R r^2
  EXPECT_NEAR(report.volume.value(), smooth, 0.005 * smooth);
}

TEST(MeshChecks, TorusWithTwoHolesKeepsItsGenus)
{
  TriMesh mesh = corpus::torus(16);
  mesh.triangles.erase(mesh.triangles.begin() + 200);
  mesh.triangles.erase(mesh.triangles.begin());
  const MeshReport report = describeMesh(mesh);
  EXPECT_EQ(report.boundaryLoops, 2U);
  EXPECT_EQ(report.eulerCharacteristic, -2);
  EXPECT_EQ(report.genus, 1);
}

TEST(MeshChecks, MoebiusStripIsManifoldButNotOriented)
{
  const MeshReport report = describeMesh(corpus::moebius());
  EXPECT_TRUE(report.isManifold);
  EXPECT_FALSE(report.isOriented);
  EXPECT_EQ(report.boundaryLoops, 1U);
  EXPECT_EQ(report.eulerCharacteristic, 0);
  EXPECT_FALSE(report.genus.has_value());
}

TEST(MeshChecks, FlippedTriangleMisorientsItsThreeEdges)
{
  TriMesh mesh = corpus::tetrahedron();
  std::swap(mesh.triangles[0][0], mesh.triangles[0][1]);
  const MeshReport report = describeMesh(mesh);
  EXPECT_EQ(report.misorientedEdges, 3U);
  EXPECT_TRUE(report.isClosed && report.isManifold);
  EXPECT_FALSE(report.isOriented);
  EXPECT_FALSE(report.volume.has_value());
}

TEST(MeshChecks, SharedEdgeIsNonManifoldButClosed)
{
  const MeshReport report = describeMesh(corpus::tetrahedraOnOneEdge());
  EXPECT_EQ(report.nonManifoldEdges, 1U);
  EXPECT_EQ(report.nonManifoldVertices, 0U); // the edge explains both of its ends
  EXPECT_FALSE(report.isManifold);
  EXPECT_TRUE(report.isClosed && report.isOriented);
  EXPECT_EQ(report.components.size(), 1U);
  EXPECT_FALSE(report.genus.has_value());
  EXPECT_NEAR(report.volume.value(), 2.0 / 6.0, 1e-15);
}

TEST(MeshChecks, SharedPointIsANonManifoldVertexOfTwoSpheres)
{
  const MeshReport report = describeMesh(corpus::tetrahedraOnOnePoint());
  EXPECT_EQ(report.nonManifoldEdges, 0U);
  EXPECT_EQ(report.nonManifoldVertices, 1U);
  EXPECT_FALSE(report.isManifold);
  EXPECT_EQ(report.eulerCharacteristic, 3); // two spheres less the shared point
  ASSERT_EQ(report.components.size(), 2U);
  EXPECT_EQ(report.components[1].points, 4U);
  EXPECT_EQ(report.components[1].eulerCharacteristic, 2);
  EXPECT_EQ(report.components[1].genus, 0);
}

TEST(MeshChecks, BowTieIsANonManifoldVertexWithTwoLoops)
{
  const MeshReport report =
    describeMesh({ { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { -1, 0, 0 }, { -1, -1, 0 } },
      { { 0, 1, 2 }, { 0, 3, 4 } } });
  EXPECT_EQ(report.nonManifoldVertices, 1U);
  EXPECT_EQ(report.boundaryLoops, 2U);
}

TEST(MeshChecks, DuplicateTriangleMakesThreeCrowdedEdges)
{
  TriMesh mesh = corpus::tetrahedron();
  mesh.triangles.push_back(mesh.triangles[0]);
  const MeshReport report = describeMesh(mesh);
  EXPECT_EQ(report.nonManifoldEdges, 3U);
  EXPECT_FALSE(report.isManifold);
  EXPECT_FALSE(report.isClosed); // odd edges leak
}

TEST(MeshChecks, CollapsedAndFlatTrianglesAreCountedApart)
{
  const MeshReport report =
    describeMesh({ { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 } }, { { 0, 1, 2 }, { 0, 1, 1 } } });
  EXPECT_EQ(report.collapsedTriangles, 1U);
  EXPECT_EQ(report.flatTriangles, 1U);
  EXPECT_FALSE(report.isManifold);
  EXPECT_EQ(report.components.size(), 1U);
  EXPECT_EQ(report.edges, 3U);
}

TEST(MeshChecks, LargestComponentComesFirst)
{
  TriMesh mesh = corpus::square();
  const TriMesh body = corpus::torus(8);
  for (const Triangle& corner : body.triangles)
  {
    mesh.triangles.push_back({ corner[0] + 4, corner[1] + 4, corner[2] + 4 });
  }
  mesh.points.insert(mesh.points.end(), body.points.begin(), body.points.end());
  mesh.points.push_back({ 9, 9, 9 });
  const MeshReport report = describeMesh(mesh);
  ASSERT_EQ(report.components.size(), 2U);
  EXPECT_EQ(report.components[0].triangles, 128U);
  EXPECT_EQ(report.components[0].genus, 1);
  EXPECT_EQ(report.components[1].boundaryLoops, 1U);
  EXPECT_EQ(report.points - report.pointsUsed, 1U);
  EXPECT_EQ(report.boxMax.z, 9.0);
}

TEST(MeshChecks, EmptyMeshIsNeitherClosedNorBroken)
{
  const MeshReport report = describeMesh({});
  EXPECT_FALSE(report.isClosed);
  EXPECT_TRUE(report.isManifold);
  EXPECT_EQ(report.shortestEdge, 0.0);
  EXPECT_EQ(report.boxDiagonal, 0.0);
}

TEST(MeshChecks, MissingPointIsRefused)
{
  EXPECT_THROW(describeMesh({ { { 0, 0, 0 } }, { { 0, 1, 2 } } }), Error);
}
