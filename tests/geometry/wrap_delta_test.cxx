// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/wrap_delta.h"

#include "filters/base/error.h"
#include "filters/geometry/pushes.h"
#include "filters/geometry/wrap.h"
#include "tests/geometry/complex_corpus.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace scan::test
{
namespace
{

WrapModel wrapOf(const PointSet& set)
{
  Execution execution;
  return wrap(set.points, { .mode = WrapOptions::Mode::classic }, execution).model;
}

void expectRoundTrip(const WrapComplex& from, const WrapComplex& to, const Basins& basins)
{
  const WrapComplex again = applyDelta(from, deltaOf(from, to, basins), basins, true);
  EXPECT_TRUE(again == to);
  EXPECT_TRUE(again.followsFlow());
}

TEST(WrapDelta, LeadsToAnyState)
{
  for (const PointSet& set : pointSets(testSeed()))
  {
    SCOPED_TRACE(set.name + ", SCAN_TEST_SEED=" + std::to_string(set.seed));
    const WrapModel model = wrapOf(set);
    const Basins& basins = model.scan->basins();
    const Index tets = model.scan->delaunay().tetCount();
    std::mt19937_64 random(set.seed);
    WrapComplex state = *model.start;
    expectRoundTrip(*model.start, state, basins);
    for (int change = 0; change < 200; ++change)
    {
      const auto tet = static_cast<Index>(random() % tets);
      const auto facet = static_cast<Facet>(random() % (4 * tets));
      random() % 2 == 0 ? state.keepTet(tet) : state.dropTet(tet);
      random() % 2 == 0 ? state.keepSheet(facet) : state.dropSheet(facet);
    }
    expectRoundTrip(*model.start, state, basins);
    expectRoundTrip(state, *model.start, basins);
  }
}

TEST(WrapDelta, OfAPushIsAlikeOverWholeBasins)
{
  Execution execution;
  PointSet sphere{ "sphere", 1, {} };
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 800; ++i)
  {
    const Vec3 p{ normal(random), normal(random), normal(random) };
    sphere.points.push_back(p * (1.0 / std::sqrt(dot(p, p))));
  }
  WrapModel model = wrapOf(sphere);
  const WrapComplex before = *model.current;
  const auto boundary = surfaceOf(model, true, execution).facets;
  ASSERT_FALSE(boundary.empty());
  push(model, boundary, {}, {}, execution);
  const std::vector<std::uint8_t> delta = deltaOf(before, *model.current, model.scan->basins());
  const auto turns = std::ranges::count_if(
    delta, [&](const std::uint8_t& byte) { return &byte != delta.data() && byte != *(&byte - 1); });
  EXPECT_GT(std::ranges::count(delta, 16), 1000);
  EXPECT_LE(turns, 20);
}

TEST(WrapDelta, RefusesOthers)
{
  const WrapModel model = wrapOf(pointSets(testSeed()).front());
  std::vector<std::uint8_t> delta(model.start->bytes().size() - 1);
  EXPECT_THROW(applyDelta(*model.start, delta, model.scan->basins(), true), Error);
  delta.resize(delta.size() + 1);
  EXPECT_NO_THROW(applyDelta(*model.start, delta, model.scan->basins(), true));
}

} // namespace
} // namespace scan::test
