// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/pushes.h"

#include "filters/base/error.h"
#include "filters/geometry/size_scale.h"
#include "filters/geometry/wrap.h"
#include "tests/geometry/complex_corpus.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace scan::test
{
namespace
{

constexpr double kInfinity = std::numeric_limits<double>::infinity();

WrapResult wrapped(const std::vector<Vec3>& points, const WrapOptions& options)
{
  Execution execution(2);
  return wrap(points, options, execution);
}

PushReport pushed(WrapModel& model, Facet mark, const PushOptions& options)
{
  Execution execution(1);
  return push(model, std::vector{ mark }, {}, options, execution);
}

PushReport pulled(WrapModel& model, const BlockName& block, const PushOptions& options)
{
  Execution execution(1);
  return pull(model, std::vector{ block }, options, execution);
}

/// Two sheets of a thick plate with a hole: hollows of several sizes.
std::vector<Vec3> platePoints(std::uint64_t seed)
{
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> at(-1.0, 1.0);
  std::vector<Vec3> points;
  while (points.size() < 1500)
  {
    const double x = at(random);
    const double y = at(random);
    if (std::hypot(x, y) > 0.45)
    {
      points.push_back({ x, y, random() % 2 == 0 ? 0.0 : 0.4 });
    }
    const double turn = std::numbers::pi * at(random);
    points.push_back({ 0.45 * std::cos(turn), 0.45 * std::sin(turn), 0.2 + 0.2 * at(random) });
  }
  return points;
}

/// The corpus and a plate.
std::vector<PointSet> scans(std::uint64_t seed)
{
  std::vector<PointSet> sets = pointSets(seed);
  sets.push_back({ "plate", seed, platePoints(seed) });
  return sets;
}

long eulerCharacteristic(const WrapModel& model)
{
  long euler = 0;
  for (const Simplex& simplex : simplicesOf(model))
  {
    euler += simplex.size() % 2 == 1 ? 1 : -1;
  }
  return euler;
}

void expectCanonical(const WrapComplex& kept)
{
  for (Facet facet = 0; facet < 4 * kept.flow().delaunay().tetCount(); ++facet)
  {
    ASSERT_FALSE(kept.isSheet(facet) && kept.keptSides(facet) > 0);
  }
}

/// A triangle of the surface by chance, kNone when there is none left.
Facet someTriangle(const WrapModel& model, std::mt19937_64& random)
{
  Execution execution(1);
  const std::vector<Facet> facets = surfaceOf(model, false, execution).facets;
  return facets.empty() ? kNone : facets[random() % facets.size()];
}

TEST(Pushes, EulerCharacteristicChangesAsReportedAndStatesStayCanonical)
{
  for (const PointSet& set : scans(testSeed()))
  {
    for (const WrapOptions::Mode mode :
      { WrapOptions::Mode::classic, WrapOptions::Mode::automatic })
    {
      SCOPED_TRACE(set.name + ", SCAN_TEST_SEED=" + std::to_string(set.seed));
      std::mt19937_64 random(set.seed);
      WrapModel model = wrapped(set.points, { .mode = mode }).model;
      Execution execution(1);
      const Blocks& blocks = model.scan->blocks(execution);
      std::vector<BlockName> removed;
      for (int step = 0; step < 12; ++step)
      {
        const WrapModel before = model;
        const WrapComplex copy = *before.current;
        const PushOptions options{ .deep = random() % 2 == 0, .reach = 1.0 + 0.25 * (step % 4) };
        const Facet mark = someTriangle(model, random);
        PushReport report;
        if (mark != kNone && (removed.empty() || random() % 3 > 0))
        {
          report = pushed(model, mark, options);
          EXPECT_FALSE(report.blocks.empty());
          EXPECT_LE(report.change.tetrahedra, 0);
          removed.insert(removed.end(), report.blocks.begin(), report.blocks.end());
        }
        else if (!removed.empty())
        {
          report = pulled(model, removed[random() % removed.size()], options);
          EXPECT_GE(report.change.tetrahedra, 0);
        }
        EXPECT_EQ(*before.current, copy); // nobody changes an old state
        expectCanonical(*model.current);
        ASSERT_EQ(eulerCharacteristic(model) - eulerCharacteristic(before),
          report.change.eulerCharacteristic());
        if (model.isSolid)
        {
          EXPECT_EQ(surfaceOf(model, false, execution).report.sheetTriangles, 0U);
        }
      }
      for (const BlockName& block : removed)
      {
        EXPECT_GE(sizeOf(blocks, block), 0.0);
      }
    }
  }
}

/// Euler characteristic of removals in a wrap that was not edited otherwise: each volume block is
/// one cell less of dimension three, each wall one of dimension two, each lost line one of one.
TEST(Pushes, OnlyCriticalSimplicesChangeTheTopology)
{
  const PointSet set{ "plate", testSeed(), platePoints(testSeed()) };
  SCOPED_TRACE("SCAN_TEST_SEED=" + std::to_string(set.seed));
  std::mt19937_64 random(set.seed);
  WrapModel model = wrapped(set.points, { .mode = WrapOptions::Mode::classic }).model;
  for (int step = 0; step < 30; ++step)
  {
    Execution execution(1);
    const auto bare = bareEdges(*model.current, execution).size();
    const PushReport report =
      pushed(model, someTriangle(model, random), { .deep = step % 3 == 0, .reach = 1.5 });
    const auto lost = static_cast<std::int64_t>(bareEdges(*model.current, execution).size() - bare);
    std::int64_t volumes = 0;
    std::int64_t sheets = 0;
    for (const BlockName& block : report.blocks)
    {
      (block.isSheet ? sheets : volumes) += 1;
    }
    EXPECT_EQ(report.change.eulerCharacteristic(), volumes - sheets - report.doors + lost);
  }
}

TEST(Pushes, PullGivesBackTheIdenticalState)
{
  for (const PointSet& set : scans(testSeed() + 1))
  {
    for (const WrapOptions::Mode mode :
      { WrapOptions::Mode::classic, WrapOptions::Mode::automatic })
    {
      SCOPED_TRACE(set.name + ", SCAN_TEST_SEED=" + std::to_string(set.seed));
      std::mt19937_64 random(set.seed);
      WrapModel model = wrapped(set.points, { .mode = mode }).model;
      for (int step = 0; step < 100; ++step)
      {
        const Facet mark = someTriangle(model, random);
        if (mark == kNone)
        {
          break;
        }
        const PushOptions options{ .deep = step % 2 == 0 };
        WrapModel other = model;
        const PushReport report = pushed(other, mark, options);
        EXPECT_FALSE(*other.current == *model.current);
        Execution execution(1);
        pull(other, report.blocks, {}, execution);
        ASSERT_EQ(*other.current, *model.current) << "step " << step;
        if (step % 10 == 9)
        {
          pushed(model, mark, {}); // go on from another state
        }
      }
    }
  }
}

TEST(Pushes, DeepReachesMoreWithALongerReach)
{
  const WrapModel start =
    wrapped(platePoints(testSeed()), { .mode = WrapOptions::Mode::classic }).model;
  std::mt19937_64 random(testSeed());
  for (int step = 0; step < 20; ++step)
  {
    const Facet mark = someTriangle(start, random);
    std::size_t last = 0;
    for (const double reach : { 1.0, 1.25, 1.5, 2.0, 4.0 })
    {
      WrapModel model = start;
      const std::size_t count = pushed(model, mark, { .deep = true, .reach = reach }).blocks.size();
      EXPECT_GE(count, last);
      last = count;
    }
  }
}

TEST(Pushes, SurfaceChangeIsTheDifferenceOfTheSurfaces)
{
  WrapModel model = wrapped(platePoints(testSeed()), { .mode = WrapOptions::Mode::classic }).model;
  std::mt19937_64 random(testSeed());
  const auto namesOf = [](const WrapModel& of)
  {
    Execution execution(1);
    std::vector<Facet> names = surfaceOf(of, false, execution).facets;
    for (Facet& facet : names)
    {
      facet = of.scan->delaunay().canonical(facet);
    }
    std::ranges::sort(names);
    return names;
  };
  for (int step = 0; step < 10; ++step)
  {
    const std::vector<Facet> before = namesOf(model);
    const PushReport report = pushed(model, someTriangle(model, random), { .deep = step % 2 == 0 });
    const std::vector<Facet> after = namesOf(model);
    std::vector<Facet> gone;
    std::vector<Facet> added;
    std::ranges::set_difference(before, after, std::back_inserter(gone));
    std::ranges::set_difference(after, before, std::back_inserter(added));
    EXPECT_EQ(report.surface.gone, gone);
    EXPECT_EQ(report.surface.added, added);
  }
}

/// A choice at random, and the way there one simplex after the other.
struct Journey
{
  bool onlyRemoves = true;
  std::vector<Index> leaving; ///< volumes
  std::vector<Index> coming;
  std::vector<std::uint8_t> opened; ///< per critical triangle of the graph: goes when it is bare
  std::vector<std::uint8_t> closed; ///< comes

  Journey(const CollapseGraph& graph, const Blocks& blocks, std::mt19937_64& random)
    : opened(graph.criticalTriangles().size())
    , closed(graph.criticalTriangles().size())
  {
    this->onlyRemoves = random() % 2 == 0;
    for (Index block = 0; block < blocks.outside(); ++block)
    {
      if (blocks.isVolume(block) && random() % 8 == 0)
      {
        (!this->onlyRemoves && random() % 2 == 0 ? this->coming : this->leaving).push_back(block);
      }
    }
    for (Index i = 0; i < graph.criticalTriangles().size(); ++i)
    {
      this->opened[i] = random() % 3 == 0 ? 1 : 0;
      this->closed[i] = !this->onlyRemoves && this->opened[i] == 0 && random() % 8 == 0 ? 1 : 0;
    }
  }

  CriticalChoice choice(const WrapComplex& kept, const CollapseGraph& graph) const
  {
    CriticalChoice chosen = criticalChoiceOf(kept, graph.basins());
    std::ranges::for_each(this->leaving, [&](Index volume) { chosen.holdsBasin[volume] = 0; });
    std::ranges::for_each(this->coming, [&](Index volume) { chosen.holdsBasin[volume] = 1; });
    chosen.keepsTriangle = [this](Index i, bool was)
    { return this->closed[i] != 0 || (was && this->opened[i] == 0); };
    return chosen;
  }

  /// Sinks, then the triangles that are bare, as often as there are any; then what comes.
  void go(WrapEditor& editor, const WrapComplex& kept, const CollapseGraph& graph) const
  {
    Execution execution(1);
    for (const Index volume : this->leaving)
    {
      const Index sink = graph.basins().sink[volume];
      if (kept.keepsTet(sink))
      {
        editor.removeTet(sink);
      }
    }
    editor.collapse(execution);
    for (const Index volume : this->coming)
    {
      editor.addLowerSet(graph.basins().sink[volume], nullptr, execution);
    }
    for (Index i = 0; i < graph.criticalTriangles().size(); ++i)
    {
      if (this->closed[i] != 0)
      {
        editor.addLowerSetOfTriangle(graph.criticalTriangles()[i], nullptr, execution);
      }
    }
    for (bool changed = true; changed;)
    {
      changed = false;
      for (Index i = 0; i < graph.criticalTriangles().size(); ++i)
      {
        if (this->opened[i] != 0 && kept.isSheet(graph.criticalTriangles()[i]))
        {
          editor.removeSheet(graph.criticalTriangles()[i]);
          editor.collapse(execution);
          changed = true;
        }
      }
    }
  }
};

Index criticalTrianglesOf(const WrapComplex& kept, const CollapseGraph& graph)
{
  return static_cast<Index>(std::ranges::count_if(
    graph.criticalTriangles(), [&](Facet facet) { return kept.keepsTriangle(facet); }));
}

TEST(Pushes, InBulkAndOneByOneAreTheSame)
{
  for (const PointSet& set : scans(testSeed() + 3))
  {
    SCOPED_TRACE(set.name + ", SCAN_TEST_SEED=" + std::to_string(set.seed));
    std::mt19937_64 random(set.seed);
    const WrapModel start = wrapped(set.points, { .mode = WrapOptions::Mode::classic }).model;
    Execution execution(2);
    const Blocks& blocks = start.scan->blocks(execution);
    const CollapseGraph graph(blocks, execution);
    WrapComplex bulky = *start.start;
    WrapComplex single = *start.start;
    WrapEditor bulk(bulky, *start.lines);
    WrapEditor one(single, *start.lines);
    for (int step = 0; step < 12; ++step)
    {
      const Journey journey(graph, blocks, random);
      const Index before = criticalTrianglesOf(bulky, graph);
      const Index opened = bulk.choose(graph, journey.choice(bulky, graph), execution);
      journey.go(one, single, graph);
      ASSERT_EQ(bulky, single) << "step " << step;
      EXPECT_EQ(bulk.change().tetrahedra, one.change().tetrahedra);
      EXPECT_EQ(bulk.change().triangles, one.change().triangles);
      EXPECT_EQ(bulk.change().edges, one.change().edges);
      if (journey.onlyRemoves)
      {
        EXPECT_EQ(opened, before - criticalTrianglesOf(bulky, graph));
      }
    }
  }
}

/// How many tetrahedra and free triangles are kept, or not, unlike their representatives.
Index strayed(const Representatives& found, const WrapComplex& kept)
{
  const FlowComplex& flow = kept.flow();
  const auto keeps = [&](Upper upper)
  { return upper.isTet ? kept.keepsTet(upper.name) : kept.keepsTriangle(upper.name); };
  const auto strays = [&](Upper upper)
  {
    const Representatives::Code code = found.of(upper);
    return keeps(upper) != (code != kNone && keeps(found.at(code))) ? 1 : 0;
  };
  Index count = 0;
  for (Index tet = 0; tet < flow.delaunay().tetCount(); ++tet)
  {
    count += strays({ true, tet });
    for (Facet facet = 4 * tet; facet < 4 * tet + 4; ++facet)
    {
      const bool isOne = flow.delaunay().canonical(facet) == facet && flow.isFree(facet);
      count += isOne ? strays({ false, facet }) : 0;
    }
  }
  return count;
}

TEST(Representatives, StayAndGoWithWhatTheyStandFor)
{
  for (const PointSet& set : scans(testSeed() + 5))
  {
    SCOPED_TRACE(set.name + ", SCAN_TEST_SEED=" + std::to_string(set.seed));
    std::mt19937_64 random(set.seed);
    const WrapModel start = wrapped(set.points, { .mode = WrapOptions::Mode::classic }).model;
    Execution execution(2);
    const Blocks& blocks = start.scan->blocks(execution);
    const CollapseGraph graph(blocks, execution);
    const Representatives found(start.scan->flow(), execution);
    WrapComplex kept = *start.start;
    WrapEditor editor(kept, *start.lines);
    ASSERT_EQ(strayed(found, kept), 0U);
    for (int step = 0; step < 8; ++step)
    {
      Journey(graph, blocks, random).go(editor, kept, graph);
      ASSERT_EQ(strayed(found, kept), 0U) << "step " << step;
    }
  }
}

/// What is prepared answers sooner and nothing else.
TEST(Pushes, PreparedOrNotTheyAreTheSame)
{
  for (const PointSet& set : scans(testSeed() + 4))
  {
    SCOPED_TRACE(set.name + ", SCAN_TEST_SEED=" + std::to_string(set.seed));
    std::mt19937_64 random(set.seed);
    const auto once = [&](bool isPrepared)
    {
      Execution execution(2);
      WrapModel model = wrapped(set.points, { .mode = WrapOptions::Mode::classic }).model;
      if (isPrepared)
      {
        model.scan->prepareEdits(execution);
      }
      return model;
    };
    for (int step = 0; step < 4; ++step)
    {
      std::array<WrapModel, 2> models{ once(false), once(true) };
      const Facet mark = someTriangle(models[0], random);
      if (mark == kNone)
      {
        break;
      }
      std::array<PushReport, 2> pushes;
      std::array<PushReport, 2> pulls;
      for (std::size_t i = 0; i < 2; ++i)
      {
        pushes[i] = pushed(models[i], mark, { .deep = true });
      }
      // both scans were made anew, from the same points
      EXPECT_TRUE(
        models[0].current->isEqualIn(*models[1].current, 0, models[0].scan->delaunay().tetCount()));
      for (std::size_t i = 0; i < 2; ++i)
      {
        pulls[i] = pulled(models[i], pushes[i].blocks.front(), { .deep = true });
      }
      for (const auto& reports : { pushes, pulls })
      {
        EXPECT_EQ(reports[0].blocks, reports[1].blocks);
        EXPECT_EQ(reports[0].doors, reports[1].doors);
        EXPECT_EQ(reports[0].change.triangles, reports[1].change.triangles);
        EXPECT_EQ(reports[0].change.edges, reports[1].change.edges);
        EXPECT_EQ(reports[0].surface.gone, reports[1].surface.gone);
      }
      EXPECT_TRUE(
        models[0].current->isEqualIn(*models[1].current, 0, models[0].scan->delaunay().tetCount()));
    }
  }
}

TEST(SizeScale, AnyStepGivesTheWrapOfThatSize)
{
  for (const PointSet& set : scans(testSeed() + 2))
  {
    SCOPED_TRACE(set.name + ", SCAN_TEST_SEED=" + std::to_string(set.seed));
    std::mt19937_64 random(set.seed);
    const WrapModel start = wrapped(set.points, { .mode = WrapOptions::Mode::classic }).model;
    Execution execution(1);
    const SizeScale& sizes = start.scan->sizes(execution);
    WrapComplex slid = *start.start;
    double size = kInfinity;
    for (int step = 0; step < 8; ++step)
    {
      const double next = step == 4 ? kInfinity : std::exp(-4.0 * std::ldexp(random() >> 11, -53));
      WrapEditor editor(slid, *start.lines);
      sizes.resize(editor, slid, size, next, execution);
      size = next;
      const WrapModel direct =
        wrap(start.scan, { .mode = WrapOptions::Mode::classic, .size = size }, execution).model;
      ASSERT_EQ(slid, *direct.current) << size;
      expectCanonical(slid);
    }
  }
}

TEST(SizeScale, SmallerSizesKeepLess)
{
  const WrapModel start =
    wrapped(platePoints(testSeed()), { .mode = WrapOptions::Mode::classic }).model;
  Execution execution(1);
  Index last = kNone;
  for (const double size : { kInfinity, 1.0, 0.3, 0.2, 0.1, 0.05, 0.01, 0.0 })
  {
    const WrapResult result =
      wrap(start.scan, { .mode = WrapOptions::Mode::classic, .size = size }, execution);
    EXPECT_LE(result.report.tetrahedraKept, last);
    last = result.report.tetrahedraKept;
  }
  EXPECT_EQ(last, 0U);
}

TEST(Blocks, AreReachedFromOutsideThroughTheirOpening)
{
  const WrapModel model =
    wrapped(platePoints(testSeed()), { .mode = WrapOptions::Mode::classic }).model;
  Execution execution(1);
  const Blocks& blocks = model.scan->blocks(execution);
  // the widest way by relaxation, block after block, until nothing gets wider
  std::vector<double> widest(blocks.outside() + 1, 0.0);
  widest[blocks.outside()] = kInfinity;
  for (bool changed = true; changed;)
  {
    changed = false;
    for (const Door& door : blocks.doors())
    {
      EXPECT_LE(door.radius, (1.0 + 1e-9) * std::min(blocks.size(door.a), blocks.size(door.b)));
      for (const auto& [from, to] : { std::pair{ door.a, door.b }, std::pair{ door.b, door.a } })
      {
        const double through = std::min(widest[from], door.radius);
        changed = changed || through > widest[to];
        widest[to] = std::max(widest[to], through);
      }
    }
  }
  for (Index block = 0; block < blocks.outside(); ++block)
  {
    if (blocks.isVolume(block))
    {
      EXPECT_EQ(blocks.opening(block), widest[block]);
      EXPECT_GE(blocks.persistence(block), 1.0);
    }
  }
}

TEST(BlockMarks, NumbersNameBlocksAndOthersAreRefused)
{
  const WrapModel model =
    wrapped(platePoints(testSeed()), { .mode = WrapOptions::Mode::classic }).model;
  Execution execution(1);
  const Blocks& blocks = model.scan->blocks(execution);
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 50; ++i)
  {
    const BlockName block = blockBehind(model, blocks, someTriangle(model, random));
    EXPECT_EQ(blockOfNumber(blocks, numberOf(block)), block);
    EXPECT_TRUE(isKept(*model.current, blocks, block));
  }
  EXPECT_THROW(blockOfNumber(blocks, blocks.outside()), Error);
  EXPECT_THROW(blockOfNumber(blocks, -1 - 4LL * model.scan->delaunay().tetCount()), Error);
}

TEST(BlockMarks, APointInARemovedBlockMeansThatBlock)
{
  const WrapModel start =
    wrapped(platePoints(testSeed()), { .mode = WrapOptions::Mode::classic }).model;
  Execution execution(1);
  const Blocks& blocks = start.scan->blocks(execution);
  const DelaunayComplex& complex = start.scan->delaunay();
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 20; ++i)
  {
    WrapModel model = start;
    const PushReport report = pushed(model, someTriangle(start, random), {});
    ASSERT_EQ(report.blocks.size(), 1U);
    if (report.blocks.front().isSheet)
    {
      continue;
    }
    Vec3 middle;
    for (const Index v : complex.tetrahedra[blocks.sink(report.blocks.front().name)])
    {
      middle = middle + complex.points[v] * 0.25;
    }
    EXPECT_EQ(removedBlockAt(model, middle, execution), report.blocks.front());
  }
}

} // namespace
} // namespace scan::test
