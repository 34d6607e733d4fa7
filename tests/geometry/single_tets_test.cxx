// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/single_tets.h"

#include "tests/geometry/complex_corpus.h"
#include "tests/geometry/edit_fixtures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace scan::test
{
namespace
{

using Mode = WrapOptions::Mode;

/// Facets of the tetrahedron behind a boundary triangle that something is kept beyond.
std::vector<Facet> innerFacets(const WrapModel& model, Facet triangle)
{
  std::vector<Facet> inner;
  for (Facet facet = triangle / 4 * 4; facet < triangle / 4 * 4 + 4; ++facet)
  {
    if (model.current->keptSides(facet) == 2)
    {
      inner.push_back(facet);
    }
  }
  return inner;
}

TEST(SingleTets, FillingWhereAPushBaredGivesTheStateBefore)
{
  Execution execution(1);
  for (const PointSet& set : pointSets(testSeed()))
  {
    for (const Mode mode : { Mode::automatic, Mode::classic })
    {
      SCOPED_TRACE(set.name + ", SCAN_TEST_SEED=" + std::to_string(set.seed));
      const WrapModel before = wrappedModel(set.points, mode);
      for (const Facet triangle : surfaceFacets(before))
      {
        const std::vector<Facet> inner = innerFacets(before, triangle);
        if (before.current->isSheet(triangle) || inner.empty())
        {
          continue;
        }
        WrapModel model = before;
        const EditReport report = pushTets(model, std::array{ triangle }, execution);
        EXPECT_EQ(report.change.tetrahedra, -1);
        // named from either side
        const Facet bared = inner.front();
        const Facet mirror = before.scan->delaunay().mirror[bared / 4][bared % 4];
        fillTets(model, std::array{ triangle % 2 == 0 ? bared : mirror }, execution);
        ASSERT_EQ(*model.current, *before.current) << triangle;
      }
    }
  }
}

TEST(SingleTets, WhatMarksMeanDoesNotDependOnTheirOrder)
{
  Execution execution(1);
  const PointSet set = pointSets(testSeed()).front();
  const WrapModel before = wholeModel(set.points);
  std::vector<Facet> marks = surfaceFacets(before);
  WrapModel forward = before;
  const EditReport report = pushTets(forward, marks, execution);
  expectReported(before, report, forward);
  std::ranges::reverse(marks);
  WrapModel backward = before;
  pushTets(backward, marks, execution);
  EXPECT_EQ(*forward.current, *backward.current);
  EXPECT_LT(report.change.tetrahedra, 0);
  for (const Facet facet : surfaceFacets(forward))
  {
    EXPECT_FALSE(forward.current->isSheet(facet)) << "a stray sheet";
  }
}

TEST(SingleTets, ASheetTriangleGoesAloneAndIsFilledOnTheSideOfTheFacet)
{
  Execution execution(1);
  WrapModel sheet =
    wrappedModel(readPoints(std::string(SCAN_DATA_DIR) + "/helix.xyz"), Mode::classic);
  auto bare = std::make_shared<WrapComplex>(sheet.scan->flow());
  Facet inside = 0; // a triangle with tetrahedra on both sides
  while (sheet.scan->delaunay().mirror[inside / 4][inside % 4] == kNone)
  {
    ++inside;
  }
  bare->keepSheet(inside);
  sheet.current = bare;
  sheet.lines = std::make_shared<const std::vector<CriticalEdge>>();

  WrapModel pushed = sheet;
  const EditReport report = pushTets(pushed, std::array{ inside }, execution);
  EXPECT_EQ(report.surface.gone, std::vector{ sheet.scan->delaunay().canonical(inside) });
  EXPECT_EQ(report.change.triangles, -1);
  EXPECT_EQ(report.change.edges, -3);
  for (const Facet side : { inside, sheet.scan->delaunay().mirror[inside / 4][inside % 4] })
  {
    WrapModel filled = sheet;
    expectReported(sheet, fillTets(filled, std::array{ side }, execution), filled);
    EXPECT_TRUE(filled.current->keepsTet(side / 4));
    EXPECT_EQ(filled.current->keptTetCount(), 1U);
  }
}

} // namespace
} // namespace scan::test
