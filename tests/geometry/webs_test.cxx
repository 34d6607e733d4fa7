// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/webs.h"

#include "filters/geometry/flatten.h"
#include "filters/geometry/mesh_checks.h"
#include "tests/geometry/complex_corpus.h"
#include "tests/geometry/edit_fixtures.h"

#include <gtest/gtest.h>

#include <fstream>
#include <random>

namespace scan::test
{
namespace
{

using Mode = WrapOptions::Mode;

std::string sample(const std::string& name)
{
  return std::string(SCAN_DATA_DIR) + "/" + name;
}

/// The scanned surface: one sheet with a border.
WrapModel saddle()
{
  Execution execution(1);
  WrapModel model = wrappedModel(readPoints(sample("monkey_saddle.xyz")), Mode::classic);
  flatten(model, {}, execution);
  return model;
}

TEST(RemoveWebs, LeavesASheetWithABorderAlone)
{
  Execution execution(1);
  const WrapModel before = saddle();
  WrapModel model = before;
  removeWebs(model, {}, {}, execution);
  EXPECT_EQ(*model.current, *before.current);
}

TEST(RemoveWebs, RemovesWhatHangsOverTheSurface)
{
  Execution execution(1);
  const WrapModel clean = saddle();
  WrapModel model = clean;
  ModelEdit fins(model);
  std::mt19937_64 random(testSeed());
  for (int added = 0; added < 40;) // single triangles that stand on one or two edges of the sheet
  {
    const auto facet = static_cast<Facet>(random() % (4 * model.scan->delaunay().tetCount()));
    int standing = 0;
    int free = 0;
    for (const Index apex : model.scan->delaunay().facetVertices(facet))
    {
      const int triangles = keptTrianglesAtEdge(fins.kept(), { facet, apex }, 3);
      standing += triangles >= 2 ? 1 : 0;
      free += triangles == 0 ? 1 : 0;
    }
    if (standing > 0 && free > 0 && standing + free == 3 && !fins.kept().keepsTriangle(facet))
    {
      fins.editor().addSheet(facet);
      ++added;
    }
  }
  fins.finish(execution);
  const WrapModel before = model;
  const WebReport report = removeWebs(model, {}, {}, execution);
  expectReported(before, report, model);
  EXPECT_EQ(report.change.triangles, -40);
  EXPECT_GT(report.hanging, 0U);
  EXPECT_EQ(*model.current, *clean.current) << "SCAN_TEST_SEED=" << testSeed();
}

/// The scanned surface without its middle, which a web spans.
WrapModel saddleWithHole()
{
  Execution execution(1);
  std::vector<Vec3> points = readPoints(sample("monkey_saddle.xyz"));
  std::erase_if(points, [](const Vec3& p) { return p.x * p.x + p.y * p.y < 0.3 * 0.3; });
  WrapModel model = wrappedModel(points, Mode::classic);
  flatten(model, {}, execution);
  return model;
}

TEST(RemoveWebs, OpensAHoleInTheScan)
{
  Execution execution(1);
  const WrapModel before = saddleWithHole();
  EXPECT_EQ(describeMesh(surfaceOf(before, false, execution).surface).boundaryLoops, 1U);
  WrapModel model = before;
  const WebReport report = removeWebs(model, {}, {}, execution);
  expectReported(before, report, model);
  EXPECT_GT(report.sparse, 0U);
  const MeshReport mesh = describeMesh(surfaceOf(model, false, execution).surface);
  EXPECT_TRUE(mesh.isManifold);
  EXPECT_EQ(mesh.boundaryLoops, 2U);
  EXPECT_EQ(mesh.eulerCharacteristic, 0);
  EXPECT_EQ(mesh.pointsUsed, before.scan->delaunay().points.size());
}

TEST(RemoveWebs, TakesItsFactor)
{
  Execution execution(1);
  const WrapModel before = saddleWithHole();
  WrapModel model = before;
  removeWebs(model, {}, { .factor = 100.0 }, execution);
  EXPECT_EQ(*model.current, *before.current);
}

TEST(RemoveWebs, WorksOnTheRegionOnly)
{
  Execution execution(1);
  const WrapModel before = saddleWithHole();
  std::vector<Facet> farFromHole = surfaceFacets(before);
  std::erase_if(farFromHole,
    [&](Facet facet)
    {
      const Vec3& p =
        before.scan->delaunay().points[before.scan->delaunay().facetVertices(facet)[0]];
      return p.x * p.x + p.y * p.y < 0.5 * 0.5;
    });
  WrapModel model = before;
  removeWebs(model, farFromHole, {}, execution);
  EXPECT_EQ(*model.current, *before.current);
}

TEST(RemoveWebs, OpensTheTorus)
{
  const std::string path = std::string(SCAN_SHARED_DIR) + "/data/synthetic/torus5k.xyz";
  if (!std::ifstream(path))
  {
    GTEST_SKIP() << "no " << path << "; set SCAN_SHARED_DIR to the larger corpus";
  }
  Execution execution(1);
  WrapModel model = wrappedModel(readPoints(path), Mode::classic);
  const WrapModel before = model;
  const WebReport report = removeWebs(model, {}, {}, execution);
  expectReported(before, report, model);
  EXPECT_EQ(report.sparse, 3U);
  const MeshReport mesh = describeMesh(surfaceOf(model, false, execution).surface);
  EXPECT_EQ(mesh.triangles, 10000U);
  EXPECT_TRUE(mesh.isClosed);
  EXPECT_TRUE(mesh.isManifold);
  EXPECT_EQ(mesh.genus, 1);
}

} // namespace
} // namespace scan::test
