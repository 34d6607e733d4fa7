// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/base/error.h"
#include "filters/geometry/flow_complex.h"
#include "filters/geometry/wrap.h"
#include "tests/geometry/complex_corpus.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace scan::test
{
namespace
{

/// Runs a statement over every point set of several seeds.
template <class Statement>
void forAllPointSets(Statement&& statement)
{
  for (std::uint64_t round = 0; round < 4; ++round)
  {
    for (const PointSet& set : pointSets(testSeed() + round))
    {
      SCOPED_TRACE(set.name + ", SCAN_TEST_SEED=" + std::to_string(set.seed));
      statement(set);
    }
  }
}

WrapComplex collapsed(const FlowComplex& flow)
{
  Execution execution;
  return collapseFromOutside(flow, execution);
}

/// Runs a statement over the flow of every such point set.
template <class Statement>
void forAllFlows(Statement&& statement)
{
  forAllPointSets(
    [&](const PointSet& set)
    {
      Execution execution;
      const DelaunayComplex complex = buildDelaunayComplex(set.points, execution);
      statement(FlowComplex(complex, execution));
    });
}

TEST(DelaunayComplex, NeighboursMirrorEachOtherAndOrientationsArePositive)
{
  forAllPointSets(
    [](const PointSet& set)
    {
      Execution execution;
      const DelaunayComplex complex = buildDelaunayComplex(set.points, execution);
      for (Facet facet = 0; facet < 4 * complex.tetCount(); ++facet)
      {
        const Facet other = complex.mirror[facet / 4][facet % 4];
        if (other == kNone)
        {
          continue;
        }
        ASSERT_EQ(complex.mirror[other / 4][other % 4], facet);
        const Triangle here = complex.facetVertices(facet);
        const Triangle there = complex.facetVertices(other);
        EXPECT_EQ(sorted({ here.begin(), here.end() }), sorted({ there.begin(), there.end() }));
      }
      using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
      const auto point = [&](Index v)
      {
        const Vec3& p = complex.points[v];
        return Kernel::Point_3(p.x, p.y, p.z);
      };
      for (const auto& v : complex.tetrahedra)
      {
        EXPECT_EQ(
          CGAL::orientation(point(v[0]), point(v[1]), point(v[2]), point(v[3])), CGAL::POSITIVE);
      }
    });
}

TEST(DelaunayComplex, DoesNotDependOnTheOrderOfThePoints)
{
  forAllPointSets(
    [](const PointSet& set)
    {
      Execution execution;
      const auto asPoints = [](const DelaunayComplex& complex)
      {
        std::set<std::set<std::array<double, 3>>> tetrahedra;
        for (const auto& v : complex.tetrahedra)
        {
          std::set<std::array<double, 3>> corners;
          for (const Index i : v)
          {
            corners.insert({ complex.points[i].x, complex.points[i].y, complex.points[i].z });
          }
          tetrahedra.insert(corners);
        }
        return tetrahedra;
      };
      std::vector<Vec3> reversed(set.points.rbegin(), set.points.rend());
      EXPECT_EQ(asPoints(buildDelaunayComplex(set.points, execution)),
        asPoints(buildDelaunayComplex(reversed, execution)));
    });
}

TEST(DelaunayComplex, MergesAndCountsDuplicatesKeepingTheFirstIndex)
{
  std::vector<Vec3> points{ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 0, 0 },
    { -0.0, 0, 0 }, { 1, 0, 0 } };
  Execution execution;
  const DelaunayComplex complex = buildDelaunayComplex(points, execution);
  EXPECT_EQ(complex.duplicates, 3U);
  EXPECT_EQ(sorted(complex.scanPoint), (std::vector<Index>{ 0, 1, 2, 3 }));
}

TEST(FlowComplex, IntervalsPartitionTheComplex)
{
  forAllFlows(
    [](const FlowComplex& flow)
    {
      std::vector<Simplex> conflicts;
      std::set<Simplex> covered;
      for (const auto& [simplex, lower] : lowerFaces(intervalsOf(flow, &conflicts)))
      {
        covered.insert(simplex);
      }
      EXPECT_TRUE(conflicts.empty()) << conflicts.size() << " simplices in two intervals";
      EXPECT_EQ(covered, allSimplices(flow.delaunay()));
    });
}

TEST(FlowComplex, CriticalSimplicesHaveEulerCharacteristicOne)
{
  forAllFlows(
    [](const FlowComplex& flow)
    {
      std::array<long, 4> critical{};
      for (const auto& [lower, upper] : intervalsOf(flow))
      {
        critical[lower.size() - 1] += lower == upper ? 1 : 0;
      }
      EXPECT_EQ(critical[0] - critical[1] + critical[2] - critical[3], 1);
      EXPECT_EQ(critical[0], static_cast<long>(flow.delaunay().points.size()));
    });
}

TEST(FlowComplex, RelationIsAcyclic)
{
  forAllFlows(
    [](const FlowComplex& flow)
    {
      const Intervals intervals = intervalsOf(flow);
      // an interval points at the intervals of its upper simplex's faces
      const std::map<Simplex, Simplex> lowerOf = lowerFaces(intervals);
      std::map<Simplex, int> colour; // 1 on the path, 2 done
      const auto visit = [&](const auto& self, const Simplex& lower) -> bool
      {
        colour[lower] = 1;
        for (const Simplex& face : facesOf(intervals.at(lower)))
        {
          const Simplex& next = lowerOf.at(face);
          if (next != lower && (colour[next] == 1 || (colour[next] == 0 && !self(self, next))))
          {
            return false;
          }
        }
        colour[lower] = 2;
        return true;
      };
      for (const auto& [lower, upper] : intervals)
      {
        if (colour[lower] == 0)
        {
          ASSERT_TRUE(visit(visit, lower));
        }
      }
    });
}

TEST(ClassicWrap, IsTheUnionOfTheLowerSetsOfTheCriticalSimplices)
{
  forAllFlows(
    [](const FlowComplex& flow)
    {
      const Intervals intervals = intervalsOf(flow);
      const std::map<Simplex, Simplex> lowerOf = lowerFaces(intervals);
      std::vector<Simplex> stack;
      for (const auto& [lower, upper] : intervals)
      {
        if (lower == upper)
        {
          stack.push_back(lower);
        }
      }
      // whole intervals, from the critical ones down to their faces
      std::set<Simplex> expected;
      while (!stack.empty())
      {
        const Simplex lower = lowerOf.at(stack.back());
        const Simplex& upper = intervals.at(lower);
        stack.pop_back();
        if (expected.insert(upper).second)
        {
          for (const Simplex& simplex : simplicesOf(lower, upper))
          {
            expected.insert(simplex);
          }
          for (const Simplex& face : facesOf(upper))
          {
            stack.push_back(face);
          }
        }
      }
      EXPECT_EQ(simplicesOf(collapsed(flow)), expected);
    });
}

TEST(ClassicWrap, IsContractibleByEulerCharacteristic)
{
  forAllFlows(
    [](const FlowComplex& flow)
    {
      long euler = 0;
      for (const Simplex& simplex : simplicesOf(collapsed(flow)))
      {
        euler += simplex.size() % 2 == 1 ? 1 : -1;
      }
      EXPECT_EQ(euler, 1);
    });
}

TEST(DelaunayComplex, RefusesPointsThatSpanNoSpace)
{
  struct Case
  {
    const char* words;
    std::vector<Vec3> points;
  };
  const std::vector<Case> cases{
    { "no point", {} },
    { "equal", { { 1, 2, 3 } } },
    { "equal", { { 1, 2, 3 }, { 1, 2, 3 }, { 1, 2, 3 }, { 1, 2, 3 }, { 1, 2, 3 } } },
    { "one line", { { 0, 0, 0 }, { 1, 1, 1 }, { 2, 2, 2 }, { 3, 3, 3 }, { 9, 9, 9 } } },
    { "one plane", { { 0, 0, 0 }, { 1, 0, 1 }, { 0, 1, 1 }, { 1, 1, 2 }, { 3, 5, 8 } } },
    { "not finite", { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, NAN } } },
    { "1e50", { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1e300 } } },
  };
  for (const Case& c : cases)
  {
    SCOPED_TRACE(c.words);
    Execution execution;
    try
    {
      buildDelaunayComplex(c.points, execution);
      ADD_FAILURE() << "accepted";
    }
    catch (const Error& error)
    {
      EXPECT_EQ(error.code(), ErrorCode::badInput);
      EXPECT_NE(std::string(error.what()).find(c.words), std::string::npos) << error.what();
    }
  }
}

} // namespace
} // namespace scan::test
