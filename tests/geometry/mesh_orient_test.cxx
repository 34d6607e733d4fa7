// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/mesh_orient.h"

#include "filters/geometry/mesh_checks.h"
#include "tests/geometry/mesh_corpus.h"

#include <gtest/gtest.h>

#include <random>

namespace scan::test
{
namespace
{

TEST(OrientConsistently, UndoesRandomFlipsOfATorus)
{
  TriMesh mesh = corpus::torus(8);
  const Triangle first = mesh.triangles.front();
  std::mt19937 random(7);
  for (std::size_t t = 1; t < mesh.triangles.size(); ++t)
  {
    if (random() % 2 == 0)
    {
      std::swap(mesh.triangles[t][0], mesh.triangles[t][1]);
    }
  }
  ASSERT_FALSE(describeMesh(mesh).isOriented);
  orientConsistently(mesh.triangles, mesh.points.size());
  EXPECT_TRUE(describeMesh(mesh).isOriented);
  EXPECT_EQ(mesh.triangles.front(), first);
}

TEST(OrientConsistently, LeavesASeamOnAMoebiusStrip)
{
  TriMesh mesh = corpus::moebius();
  orientConsistently(mesh.triangles, mesh.points.size());
  EXPECT_EQ(describeMesh(mesh).misorientedEdges, 1U);
}

} // namespace
} // namespace scan::test
