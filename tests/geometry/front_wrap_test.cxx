// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/front_wrap.h"

#include "filters/base/error.h"
#include "filters/geometry/mesh_checks.h"
#include "tests/geometry/complex_corpus.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <random>

namespace scan::test
{
namespace
{

std::vector<Vec3> spherePoints(std::size_t count)
{
  std::mt19937_64 random(testSeed());
  std::normal_distribution<double> normal;
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < count; ++i)
  {
    const Vec3 p{ normal(random), normal(random), normal(random) };
    points.push_back(p * (1.0 / std::sqrt(dot(p, p))));
  }
  return points;
}

TEST(FrontWrap, SphereIsOneClosedSurfaceThroughEveryPoint)
{
  const std::vector<Vec3> points = spherePoints(2000);
  Execution execution;
  const MeshReport mesh = describeMesh({ points, frontWrap(points, execution) });
  EXPECT_EQ(mesh.pointsUsed, points.size());
  EXPECT_EQ(mesh.components.size(), 1U);
  EXPECT_TRUE(mesh.isClosed);
  EXPECT_TRUE(mesh.isManifold);
  EXPECT_TRUE(mesh.isOriented);
}

TEST(FrontWrap, HalfSphereKeepsItsRim)
{
  std::vector<Vec3> points = spherePoints(4000);
  std::erase_if(points, [](const Vec3& p) { return p.z < 0.0; });
  Execution execution;
  const MeshReport mesh = describeMesh({ points, frontWrap(points, execution) });
  EXPECT_EQ(mesh.boundaryLoops, 1U);
  EXPECT_TRUE(mesh.isManifold);
}

TEST(FrontWrap, TooFewPointsGiveNothing)
{
  Execution execution;
  EXPECT_TRUE(frontWrap(std::vector<Vec3>{}, execution).empty());
  EXPECT_TRUE(frontWrap(std::vector<Vec3>{ { 0, 0, 0 }, { 1, 0, 0 } }, execution).empty());
}

TEST(FrontWrap, StopsWhenCancelled)
{
  const CancelToken token;
  token.cancel();
  Execution execution(1, token);
  EXPECT_THROW(frontWrap(spherePoints(100), execution), Cancelled);
}

TEST(FrontWrap, StopsWhenCancelledOnTheWay)
{
  const CancelToken token;
  Execution execution(1, token, [&](std::string_view, double) { token.cancel(); });
  execution.plan({ { "front", 1.0 } });
  EXPECT_THROW(frontWrap(spherePoints(2000), execution), Cancelled);
}

TEST(FrontWrap, OfAGridIsTheSameWhereverItsMemoryLies)
{
  // a grid: all its triangles have the same radius
  std::vector<Vec3> points;
  for (int i = 0; i < 400; ++i)
  {
    points.push_back({ static_cast<double>(i % 20), static_cast<double>(i / 20), 0.0 });
    points.push_back({ static_cast<double>(i % 20), static_cast<double>(i / 20), 5.0 });
  }
  const auto sorted = [&]
  {
    Execution execution;
    std::vector<Triangle> triangles = frontWrap(points, execution);
    for (Triangle& triangle : triangles)
    {
      std::ranges::sort(triangle);
    }
    std::ranges::sort(triangles);
    return triangles;
  };
  const std::vector<Triangle> first = sorted();
  std::mt19937 random(1);
  std::vector<std::unique_ptr<char[]>> blocks(3000);
  for (int run = 0; run < 10; ++run)
  {
    for (auto& block : blocks) // leaves holes of all sizes, which are filled in any order
    {
      block = random() % 2 == 0 ? std::make_unique<char[]>(16 + random() % 300) : nullptr;
    }
    EXPECT_EQ(sorted(), first) << run;
  }
}

} // namespace
} // namespace scan::test
