// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/solid_bodies.h"

#include "tests/geometry/mesh_corpus.h"
#include "writers/triangle_plane.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{

using scan::Index;
using scan::SolidBody;
using scan::TriMesh;
using scan::Vec3;

double volumeOf(const TriMesh& mesh)
{
  double sum = 0.0;
  for (const auto& [a, b, c] : mesh.triangles)
  {
    sum += dot(mesh.points[a], cross(mesh.points[b], mesh.points[c])) / 6.0;
  }
  return sum;
}

std::vector<SolidBody> bodiesOf(const TriMesh& mesh)
{
  scan::Execution execution;
  return scan::bodiesOf(mesh, "mesh", execution);
}

} // namespace

TEST(SolidBodies, AreThePieces)
{
  TriMesh mesh;
  corpus::addTetrahedron(mesh, 1.0, {});
  corpus::addTetrahedron(mesh, 2.0, { 10, 0, 0 });
  const auto bodies = bodiesOf(mesh);
  ASSERT_EQ(bodies.size(), 2U);
  EXPECT_NEAR(volumeOf(bodies[0].outer.mesh), 1.0 / 3.0, 1e-12);
  EXPECT_NEAR(volumeOf(bodies[1].outer.mesh), 8.0 / 3.0, 1e-12);
  EXPECT_TRUE(bodies[0].voids.empty() && bodies[1].voids.empty());
  EXPECT_TRUE(std::ranges::count(bodies[1].outer.mate, scan::kNone) == 0);
}

TEST(SolidBodies, GiveAVoidToTheSmallestBodyAroundIt)
{
  TriMesh mesh; // an onion: body, void, body in the void, void in that; another body beside
  corpus::addTetrahedron(mesh, 1.0, {}, true);
  corpus::addTetrahedron(mesh, 8.0, {});
  corpus::addTetrahedron(mesh, 4.0, {}, true);
  corpus::addTetrahedron(mesh, 2.0, {});
  corpus::addTetrahedron(mesh, 1.5, { 20, 0, 0 });
  const auto bodies = bodiesOf(mesh);
  ASSERT_EQ(bodies.size(), 3U);
  ASSERT_EQ(bodies[0].voids.size(), 1U);
  EXPECT_NEAR(volumeOf(bodies[0].voids[0].mesh), -64.0 / 3.0, 1e-9);
  ASSERT_EQ(bodies[1].voids.size(), 1U);
  EXPECT_NEAR(volumeOf(bodies[1].voids[0].mesh), -1.0 / 3.0, 1e-9);
  EXPECT_TRUE(bodies[2].voids.empty());
}

TEST(SolidBodies, TurnAShellThatFacesInwardsInTheOpen)
{
  TriMesh mesh;
  corpus::addTetrahedron(mesh, 1.0, {}, true);
  const auto bodies = bodiesOf(mesh);
  ASSERT_EQ(bodies.size(), 1U);
  EXPECT_NEAR(volumeOf(bodies[0].outer.mesh), 1.0 / 3.0, 1e-12);
}

TEST(TrianglePlane, HoldsTheCornersOfThinTrianglesFarAway)
{
  const Vec3 far{ 5e6, -3e6, 1e6 };
  const Vec3 b = far + Vec3{ 1.0, 1.0, 0.25 };
  const Vec3 c = far + Vec3{ 0.5, 0.5 + 1e-9, 0.125 };
  const auto plane = scan::planeOf(far, b, c);
  ASSERT_TRUE(plane);
  EXPECT_NEAR(dot(plane->normal, plane->normal), 1.0, 1e-15);
  EXPECT_NEAR(dot(plane->normal, plane->along), 0.0, 1e-15);
  for (const Vec3& corner : { b, c })
  {
    EXPECT_NEAR(dot(plane->normal, corner - far), 0.0, 1e-15);
  }
  EXPECT_NEAR(plane->offset, dot(plane->normal, far), 2e-9);
  EXPECT_FALSE(scan::planeOf(far, b, far + Vec3{ 0.5, 0.5, 0.125 }));
  EXPECT_FALSE(scan::planeOf(far, b, b));
}
