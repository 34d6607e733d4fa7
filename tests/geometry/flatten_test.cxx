// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/flatten.h"

#include "filters/geometry/mesh_checks.h"
#include "filters/geometry/pushes.h"
#include "tests/geometry/edit_fixtures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace scan::test
{
namespace
{

using Mode = WrapOptions::Mode;

std::string sample(const std::string& name)
{
  return std::string(SCAN_DATA_DIR) + "/" + name;
}

void expectDisk(const WrapModel& model, Index points, Index triangles)
{
  Execution execution(1);
  const WrapResult result = surfaceOf(model, false, execution);
  const MeshReport mesh = describeMesh(result.surface);
  EXPECT_TRUE(mesh.isManifold);
  EXPECT_TRUE(mesh.isOriented);
  EXPECT_EQ(mesh.components.size(), 1U);
  EXPECT_EQ(mesh.boundaryLoops, 1U);
  EXPECT_EQ(mesh.eulerCharacteristic, 1);
  EXPECT_EQ(mesh.pointsUsed, points);
  EXPECT_EQ(mesh.triangles, triangles);
}

/// Opens the largest block that is on the surface, and all that one passes to from there.
void pushLargest(WrapModel& model)
{
  Execution execution(1);
  const Blocks& blocks = model.scan->blocks(execution);
  const std::vector<Facet> surface = surfaceFacets(model);
  const auto sizeBehind = [&](Facet facet)
  {
    const BlockName name = blockBehind(model, blocks, facet);
    return name.isSheet ? 0.0 : sizeOf(blocks, name);
  };
  push(model, std::array{ *std::ranges::max_element(surface, {}, sizeBehind) }, {},
    { .deep = true }, execution);
}

TEST(Flatten, HelixIsADiskOfAllPoints)
{
  Execution execution(1);
  WrapModel model = wrappedModel(readPoints(sample("helix.xyz")), Mode::classic);
  pushLargest(model);
  pushLargest(model);
  EXPECT_EQ(model.current->keptTetCount(), 404U);
  std::map<Index, Facet> bridges; // 17 positions of 25 points: between positions far apart
  for (const Facet facet : surfaceFacets(model))
  {
    std::array<Index, 4> id = model.scan->delaunay().tetrahedra[facet / 4];
    std::ranges::transform(
      id, id.begin(), [&](Index v) { return model.scan->delaunay().scanPoint[v]; });
    if (std::ranges::max(id) - std::ranges::min(id) > 50)
    {
      bridges.emplace(facet / 4, facet);
    }
  }
  std::vector<Facet> marks;
  for (const auto& [tet, facet] : bridges)
  {
    marks.push_back(facet);
  }
  EXPECT_EQ(push(model, marks, {}, {}, execution).blocks.size(), 20U);

  const WrapModel before = model;
  const FlattenReport report = flatten(model, {}, execution);
  EXPECT_EQ(report.parts, 384U);
  expectReported(before, report, model);
  expectDisk(model, 425, 768);
}

TEST(Flatten, SaddleIsADiskOfAllPoints)
{
  Execution execution(1);
  const WrapModel before = wrappedModel(readPoints(sample("monkey_saddle.xyz")), Mode::classic);
  WrapModel model = before;
  const FlattenReport report = flatten(model, {}, execution);
  expectReported(before, report, model);
  EXPECT_EQ(model.current->keptTetCount(), 0U);
  expectDisk(model, 2340, 4534);
}

TEST(Flatten, LeavesSolidsAlone)
{
  Execution execution(1);
  for (const Mode mode : { Mode::automatic, Mode::classic })
  {
    const WrapModel before = wrappedModel(readPoints(sample("plate_hole.xyz")), mode);
    WrapModel model = before;
    EXPECT_EQ(flatten(model, {}, execution).parts, 0U);
    EXPECT_EQ(*model.current, *before.current);
  }
}

/// One tetrahedron: four points around a height.
WrapModel sliver(double halfWidth, double lift)
{
  return wholeModel({ { -1, 0, 0 }, { 1, 0, 0 }, { 0, -halfWidth, lift }, { 0, halfWidth, lift } });
}

TEST(Flatten, KeepsTheHalfWithTheSmallerCircles)
{
  Execution execution(1);
  for (const double halfWidth : { 0.7, 1.4 })
  {
    WrapModel model = sliver(halfWidth, 0.05);
    EXPECT_EQ(flatten(model, {}, execution).parts, 1U);
    const WrapResult result = surfaceOf(model, false, execution);
    ASSERT_EQ(result.surface.triangles.size(), 2U);
    EXPECT_EQ(describeMesh(result.surface).pointsUsed, 4U);
    const double rim = std::sqrt(1.0 + halfWidth * halfWidth);
    const double shorterDiagonal = std::min(2.0, 2.0 * halfWidth);
    EXPECT_NEAR(describeMesh(result.surface).longestEdge, std::max(rim, shorterDiagonal), 0.01);
  }
}

TEST(Flatten, LosesNoPointAndKeepsWhatIsThick)
{
  Execution execution(1);
  WrapModel thick = sliver(1.0, 1.4);
  EXPECT_EQ(flatten(thick, {}, execution).parts, 0U);
  // a low pyramid: the one disk is a triangle, and its top lies off the rim
  WrapModel cap = wholeModel({ { 0, 0, 0.1 }, { 2, 0, 0 }, { -1, 1.7, 0 }, { -1, -1.7, 0 } });
  EXPECT_EQ(flatten(cap, {}, execution).parts, 0U);
}

TEST(Flatten, WorksOnTheRegionOnly)
{
  Execution execution(1);
  const WrapModel before = wrappedModel(readPoints(sample("monkey_saddle.xyz")), Mode::classic);
  WrapModel model = before;
  std::vector<Facet> sheets = surfaceFacets(before);
  std::erase_if(sheets, [&](Facet facet) { return !before.current->isSheet(facet); });
  EXPECT_EQ(flatten(model, sheets, execution).parts, 0U);
  EXPECT_EQ(*model.current, *before.current);
}

TEST(Flatten, ASolidModelWithThinPartsIsNoSolidModelAfterwards)
{
  Execution execution(1);
  WrapModel model = sliver(0.7, 0.05);
  model.isSolid = true;
  flatten(model, {}, execution);
  EXPECT_FALSE(model.isSolid);
}

} // namespace
} // namespace scan::test
