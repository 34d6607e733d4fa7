// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/bridge.h"

#include "filters/geometry/fill_holes.h"
#include "filters/geometry/mesh_checks.h"
#include "tests/geometry/hole_fixtures.h"
#include "tests/geometry/mesh_corpus.h"

#include <algorithm>
#include <iostream>

namespace scan::test
{
namespace
{

BridgeResult run(const TriMesh& mesh, const BridgeOptions& options)
{
  Execution execution(2);
  return bridge(mesh, everywhere(mesh.points), options, execution);
}

void expectOnlyAdded(const TriMesh& before, const BridgeResult& result)
{
  const TriMesh& after = result.edit.mesh;
  expectConsistent(result.edit);
  EXPECT_TRUE(std::equal(before.points.begin(), before.points.end(), after.points.begin()));
  EXPECT_TRUE(
    std::equal(before.triangles.begin(), before.triangles.end(), after.triangles.begin()));
  const MeshReport report = describeMesh(after);
  EXPECT_TRUE(report.isManifold);
  EXPECT_TRUE(report.isOriented);
  EXPECT_EQ(report.flatTriangles, 0U);
  EXPECT_EQ(intersectionsOf(after), 0U);
  EXPECT_EQ(after.points.size(), before.points.size() + result.pointsAdded);
  EXPECT_EQ(after.triangles.size(), before.triangles.size() + result.trianglesAdded);
}

/// One above the other.
TriMesh twoTubes()
{
  return together(tube(24, 6, 1.0, 2.0), tube(24, 6, 1.0, 2.0, { 0, 0, 3 }));
}

std::string refusalOf(const TriMesh& mesh, const BridgeOptions& options)
{
  try
  {
    run(mesh, options);
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.code(), ErrorCode::badParameter);
    return error.what();
  }
  return "";
}

TEST(Bridge, JoinsTwoTubes)
{
  const TriMesh mesh = twoTubes();
  for (const Index width : { 1U, 2U, 5U, 11U })
  {
    const BridgeResult result =
      run(mesh, { .from = { 1, 0.1, 2 }, .to = { 1, 0.1, 3 }, .width = width });
    expectOnlyAdded(mesh, result);
    EXPECT_TRUE(result.joinsTwo);
    EXPECT_NEAR(result.length, 1.0, 0.1);
    const MeshReport report = describeMesh(result.edit.mesh);
    EXPECT_EQ(report.components.size(), 1U);
    EXPECT_EQ(report.boundaryLoops, 3U);
    EXPECT_EQ(report.genus, 0);
    EXPECT_EQ(result.trianglesAdded % (2 * width), 0U);
    // what is left of the gap is a hole like others
    Execution execution(1);
    const FillHolesResult filled = fillHoles(result.edit.mesh, everywhere(result.edit.mesh.points),
      { .at = { { -1, 0, 2.5 } } }, execution);
    EXPECT_EQ(describeMesh(filled.edit.mesh).boundaryLoops, 2U);
  }
}

TEST(Bridge, PartsAHoleInTwo)
{
  const TriMesh mesh = torn(sphereMesh(4), [](const Vec3& at) { return at.z > 0.7; });
  const BridgeResult result =
    run(mesh, { .from = { 1, 0, 0.7 }, .to = { -1, 0, 0.7 }, .width = 3 });
  expectOnlyAdded(mesh, result);
  EXPECT_FALSE(result.joinsTwo);
  EXPECT_EQ(describeMesh(result.edit.mesh).boundaryLoops, 2U);
  Execution execution(1);
  const FillHolesResult filled =
    fillHoles(result.edit.mesh, everywhere(result.edit.mesh.points), {}, execution);
  EXPECT_TRUE(describeMesh(filled.edit.mesh).isClosed);
  EXPECT_EQ(describeMesh(filled.edit.mesh).genus, 0);
}

TEST(Bridge, SaysWhyNot)
{
  const TriMesh tubes = twoTubes();
  EXPECT_NE(refusalOf(corpus::torus(8), {}).find("no rim"), std::string::npos);
  EXPECT_NE(refusalOf(tubes, { .from = { 1, 0, 2 }, .to = { 1, 0, 2 } }).find("ends meet"),
    std::string::npos);
  EXPECT_NE(
    refusalOf(tubes, { .from = { 1, 0, 2 }, .to = { 1, 0, 3 }, .width = 24 }).find("24 edges only"),
    std::string::npos);
  TriMesh turned = tube(24, 6, 1.0, 2.0, { 0, 0, 3 });
  std::ranges::for_each(turned.triangles, [](Triangle& t) { std::swap(t[0], t[1]); });
  EXPECT_NE(refusalOf(together(tube(24, 6, 1.0, 2.0), turned),
              { .from = { 1, 0.1, 2 }, .to = { 1, 0.1, 3 } })
              .find("face opposite ways"),
    std::string::npos);
  TriMesh blocked = tubes;
  corpus::addTetrahedron(blocked, 0.5, { 1, 0.1, 2.5 });
  EXPECT_NE(refusalOf(blocked, { .from = { 1, 0.1, 2 }, .to = { 1, 0.1, 3 } }).find("cut"),
    std::string::npos);
  EXPECT_NE(refusalOf(tubes, { .from = { 1, 0.1, 2 }, .to = { 1, 0.1, 3 }, .maxDeviation = 0.3 })
              .find("limit"),
    std::string::npos);
  EXPECT_EQ(
    refusalOf(tubes, { .from = { 1, 0.1, 2 }, .to = { 1, 0.1, 3 }, .maxDeviation = 0.6 }), "");
}

TEST(Bridge, LooksForRimsInTheRegionOnly)
{
  const TriMesh mesh = twoTubes();
  std::vector<std::uint8_t> inRegion(mesh.points.size());
  std::ranges::transform(
    mesh.points, inRegion.begin(), [](const Vec3& p) { return p.z > 2.5 ? 1 : 0; });
  Execution execution(1);
  EXPECT_THROW(
    bridge(mesh, inRegion, { .from = { 1, 0, 2 }, .to = { 1, 0, 3 } }, execution), Error);
  std::ranges::fill(inRegion, std::uint8_t{ 0 });
  EXPECT_THROW(
    bridge(mesh, inRegion, { .from = { 1, 0, 2 }, .to = { 1, 0, 3 } }, execution), Error);
}

/// Any two places of torn surfaces: a good bridge or a refusal.
TEST(Bridge, IsGoodOrRefused)
{
  const std::uint64_t seed = pointSeed();
  Random random(seed);
  int built = 0;
  for (int round = 0; round < 200; ++round)
  {
    const TriMesh whole = corpus::torus(30);
    std::vector<Vec3> holes;
    for (int i = 0; i < 4; ++i)
    {
      holes.push_back(whole.points[random.below(whole.points.size())]);
    }
    const TriMesh mesh = torn(whole,
      [&](const Vec3& at)
      { return std::ranges::any_of(holes, [&](const Vec3& p) { return length(p - at) < 0.5; }); });
    if (!describeMesh(mesh).isManifold)
    {
      continue;
    }
    const BridgeOptions options{ mesh.points[random.below(mesh.points.size())],
      mesh.points[random.below(mesh.points.size())], static_cast<Index>(1 + random.below(2)) };
    if (refusalOf(mesh, options).empty())
    {
      expectOnlyAdded(mesh, run(mesh, options));
      ++built;
    }
  }
  std::cout << built << " bridges built\n";
  EXPECT_GT(built, 20) << "SCAN_TEST_SEED=" << seed;
}

TEST(Bridge, Stops)
{
  const CancelToken token;
  token.cancel();
  Execution execution(2, token);
  const TriMesh mesh = twoTubes();
  EXPECT_THROW(bridge(mesh, everywhere(mesh.points), { .from = { 1, 0.1, 2 }, .to = { 1, 0.1, 3 } },
                 execution),
    Cancelled);
}

} // namespace
} // namespace scan::test
