// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/shells.h"

#include "filters/geometry/half_edges.h"
#include "tests/geometry/mesh_corpus.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace scan;

namespace
{

Shells shellsOf(const TriMesh& mesh)
{
  Execution execution;
  Shells shells = findShells(mesh, pairEdges(mesh).mate);
  findContainers(mesh, shells, execution);
  return shells;
}

} // namespace

TEST(Shells, AreMeasured)
{
  TriMesh mesh = corpus::square();
  corpus::addTetrahedron(mesh, 3.0, { 10, 0, 0 });
  corpus::addTetrahedron(mesh, 1.0, { 20, 0, 0 }, true);
  const Shells shells = shellsOf(mesh);
  ASSERT_EQ(shells.shells.size(), 3U);
  EXPECT_FALSE(shells.shells[0].isClosed);
  EXPECT_EQ(shells.shells[0].volume, 0.0);
  EXPECT_TRUE(shells.shells[1].isClosed);
  EXPECT_NEAR(shells.shells[1].volume, 9.0, 1e-12);
  EXPECT_NEAR(shells.shells[2].volume, -1.0 / 3.0, 1e-12);
  EXPECT_EQ(shells.shells[2].container, kNone);
  EXPECT_EQ(shells.shells[2].firstTriangle, 6U);
  EXPECT_EQ(shells.shells[2].triangles, 4U);
  EXPECT_EQ(shells.shellOf[5], 1U);
}

TEST(Shells, HaveTheSmallestContainer)
{
  TriMesh mesh;
  corpus::addTetrahedron(mesh, 0.05, { 0, 0, 0 }, true); // in all of them
  corpus::addTetrahedron(mesh, 100.0, { 0, 0, 0 });
  corpus::addTetrahedron(mesh, 10.0, { 0, 0, 0 }, true); // a void of the largest
  corpus::addTetrahedron(mesh, 1.0, { 0, 0, 0 });        // a body in the void
  corpus::addTetrahedron(mesh, 1.0, { 0, 0, 30 }, true); // in the largest only, above the others
  corpus::addTetrahedron(mesh, 1.0, { 0, 0, 90 }, true); // outside, above all
  const Shells shells = shellsOf(mesh);
  EXPECT_EQ(shells.shells[0].container, 3U);
  EXPECT_EQ(shells.shells[2].container, 1U);
  EXPECT_EQ(shells.shells[4].container, 1U);
  EXPECT_EQ(shells.shells[5].container, kNone);
}

TEST(Shells, AreFoundAroundProbesBelowCornersAndEdges)
{
  // seen along z the probe's point lies on edges and corners of the cube around it
  TriMesh mesh = corpus::voxelBorder(4, [](Index, Index, Index) { return true; });
  TriMesh inner;
  inner.points = { { 1, 1.5, 1 }, { 3, 1.5, 1 }, { 2, 2, 2 }, { 2, 3, 1 } };
  // the middle of the first triangle is at 2, 2, 1
  inner.triangles = { { 0, 1, 3 }, { 0, 2, 1 }, { 1, 2, 3 }, { 2, 0, 3 } };
  const auto first = static_cast<Index>(mesh.points.size());
  mesh.points.insert(mesh.points.end(), inner.points.begin(), inner.points.end());
  for (const auto& [a, b, c] : inner.triangles)
  {
    mesh.triangles.push_back({ first + a, first + b, first + c });
  }
  const Shells shells = shellsOf(mesh);
  ASSERT_EQ(shells.shells.size(), 2U);
  ASSERT_LT(shells.shells[1].volume, 0.0);
  EXPECT_EQ(shells.shells[1].container, 0U);
}

TEST(Shells, TouchTheirContainersFromInside)
{
  // a cube in a cube, with a side in that of the other: whichever triangle comes first
  TriMesh outer = corpus::voxelBorder(3, [](Index, Index, Index) { return true; });
  const auto first = static_cast<Index>(outer.points.size());
  for (const auto& at : { Vec3{ 0, 1, 1 }, Vec3{ 2, 1, 1 }, Vec3{ 1, 1, 0 }, Vec3{ 1, 1, 2 } })
  {
    TriMesh inner = corpus::voxelBorder(1, [](Index, Index, Index) { return true; });
    for (std::size_t turn = 0; turn < inner.triangles.size(); ++turn)
    {
      std::ranges::rotate(inner.triangles, inner.triangles.begin() + 1);
      TriMesh mesh = outer;
      for (const Vec3& p : inner.points)
      {
        mesh.points.push_back(p + at);
      }
      for (const auto& [a, b, c] : inner.triangles)
      {
        mesh.triangles.push_back({ first + a, first + c, first + b });
      }
      const Shells shells = shellsOf(mesh);
      ASSERT_EQ(shells.shells.size(), 2U);
      EXPECT_EQ(shells.shells[1].container, 0U) << turn;
    }
  }
}

TEST(Shells, InOnePlaceContainNothing)
{
  TriMesh mesh;
  corpus::addTetrahedron(mesh, 1.0, { 0, 0, 0 });
  corpus::addTetrahedron(mesh, 1.0, { 0, 0, 0 }, true);
  const Shells shells = shellsOf(mesh);
  EXPECT_EQ(shells.shells[0].container, kNone);
  EXPECT_EQ(shells.shells[1].container, kNone);
}

TEST(Shells, OfManyPiecesAreNoLongWork)
{
  // above each other, each second one turned; within each other; and small ones in a large one
  constexpr int kMany = 20000;
  constexpr int kDeep = 5000;
  TriMesh stack;
  TriMesh nest;
  TriMesh bubbles;
  corpus::addTetrahedron(bubbles, 10.0 * kMany, { 0, 0, 0 });
  for (int i = 0; i < kMany; ++i)
  {
    corpus::addTetrahedron(stack, 1.0, { 0, 0, 5.0 * i }, i % 2 == 1);
    if (i < kDeep)
    {
      corpus::addTetrahedron(nest, 1.0 + i, { 0, 0, 0 }, i % 2 == 1);
    }
    corpus::addTetrahedron(bubbles, 0.1, { i * 1.0, 0, 0 }, true);
  }
  EXPECT_EQ(shellsOf(stack).shells[kMany - 1].container, kNone);
  const Shells nested = shellsOf(nest);
  EXPECT_EQ(nested.shells[0].container, 1U);
  EXPECT_EQ(outermost(nested, 0), static_cast<Index>(kDeep - 1));
  const Shells blown = shellsOf(bubbles);
  EXPECT_EQ(blown.shells[1].container, 0U);
}
