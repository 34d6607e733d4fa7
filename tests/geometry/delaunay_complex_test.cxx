// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/base/error.h"
#include "filters/geometry/delaunay_complex.h"
#include "tests/geometry/complex_corpus.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace scan::test
{
namespace
{

using Corner = std::array<double, 3>;

/// The tetrahedra by the coordinates of their corners, sorted.
using Tetrahedra = std::vector<std::array<Corner, 4>>;

Tetrahedra tetrahedraOf(const DelaunayComplex& complex)
{
  Tetrahedra all;
  for (const auto& vertices : complex.tetrahedra)
  {
    auto& corners = all.emplace_back();
    for (int k = 0; k < 4; ++k)
    {
      const Vec3& p = complex.points[vertices[k]];
      corners[k] = { p.x, p.y, p.z };
    }
    std::sort(corners.begin(), corners.end());
  }
  std::sort(all.begin(), all.end());
  return all;
}

/// The same from CGAL.
Tetrahedra referenceOf(const std::vector<Vec3>& points)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  std::vector<Kernel::Point_3> input;
  for (const Vec3& p : points)
  {
    input.emplace_back(p.x, p.y, p.z);
  }
  const CGAL::Delaunay_triangulation_3<Kernel> triangulation(input.begin(), input.end());
  Tetrahedra all;
  for (const auto cell : triangulation.finite_cell_handles())
  {
    auto& corners = all.emplace_back();
    for (int k = 0; k < 4; ++k)
    {
      const auto& p = cell->vertex(k)->point();
      corners[k] = { p.x(), p.y(), p.z() };
    }
    std::sort(corners.begin(), corners.end());
  }
  std::sort(all.begin(), all.end());
  return all;
}

/// Points enough for several threads: what the small sets have, and cells with many neighbours.
std::vector<PointSet> largePointSets(std::uint64_t seed)
{
  std::mt19937_64 random(seed);
  const auto uniform = [&] { return std::ldexp(static_cast<double>(random() >> 11), -53); };
  const auto onSphere = [&](double radius)
  {
    const double z = 2.0 * uniform() - 1.0;
    const double angle = 6.283185307179586 * uniform();
    const double r = radius * std::sqrt(1.0 - z * z);
    return Vec3{ r * std::cos(angle), r * std::sin(angle), radius * z };
  };
  std::vector<PointSet> sets;
  const auto add = [&](const char* name, int count, auto&& makePoint)
  {
    PointSet set{ name, seed, {} };
    for (int i = 0; i < count; ++i)
    {
      set.points.push_back(makePoint(i));
    }
    sets.push_back(std::move(set));
  };
  const auto integer = [](auto i) { return static_cast<double>(i); };
  add("random", 20000, [&](int) { return Vec3{ uniform(), uniform(), uniform() }; });
  add("grid", 22 * 22 * 22,
    [&](int i) {
      return Vec3{ integer(i % 22), integer(i / 22 % 22), integer(i / 484) };
    });
  add("two crossing grids in planes", 12000,
    [&](int i)
    {
      const double a = integer(i / 2 % 77);
      const double b = integer(i / 154);
      return i % 2 == 0 ? Vec3{ a, b, 0.0 } : Vec3{ 0.0, a, b };
    });
  add("one point in four distinct", 20000,
    [&](int) {
      return Vec3{ integer(random() % 17), integer(random() % 17), integer(random() % 17) };
    });
  add("around a centre", 9000, [&](int i) { return i == 8000 ? Vec3{} : onSphere(1.0); });
  add("cylinder", 12000,
    [&](int i)
    {
      const double angle = 6.283185307179586 * (i % 60) / 60.0;
      return Vec3{ std::cos(angle), std::sin(angle), 0.1 * (i / 60) };
    });
  add("clusters and an outlier", 15000,
    [&](int i)
    {
      const double size = i % 3 == 0 ? 1e-7 : 1.0;
      return i == 77 ? Vec3{ 1e12, 1.0, 1.0 }
                     : Vec3{ size * uniform() + i % 3, size * uniform(), size * uniform() };
    });
  return sets;
}

TEST(DelaunayComplex, HasTheTetrahedraThatCgalFinds)
{
  for (std::uint64_t round = 0; round < 20; ++round)
  {
    for (const PointSet& set : pointSets(testSeed() + round))
    {
      SCOPED_TRACE(set.name + ", SCAN_TEST_SEED=" + std::to_string(set.seed));
      Execution execution(1);
      EXPECT_EQ(tetrahedraOf(buildDelaunayComplex(set.points, execution)), referenceOf(set.points));
    }
  }
}

TEST(DelaunayComplex, IsTheSameOnAnyNumberOfThreads)
{
  for (const PointSet& set : largePointSets(testSeed()))
  {
    SCOPED_TRACE(set.name + ", SCAN_TEST_SEED=" + std::to_string(set.seed));
    Execution one(1);
    const DelaunayComplex expected = buildDelaunayComplex(set.points, one);
    EXPECT_EQ(tetrahedraOf(expected), referenceOf(set.points));
    for (const unsigned threads : { 2U, 4U })
    {
      Execution several(threads);
      const DelaunayComplex complex = buildDelaunayComplex(set.points, several);
      EXPECT_EQ(complex.points, expected.points);
      EXPECT_EQ(complex.scanPoint, expected.scanPoint);
      EXPECT_TRUE(complex.tetrahedra == expected.tetrahedra);
      EXPECT_TRUE(complex.mirror == expected.mirror);
    }
  }
}

TEST(DelaunayComplex, NumbersTheTetrahedraByTheirVertices)
{
  for (const PointSet& set : pointSets(testSeed()))
  {
    SCOPED_TRACE(set.name);
    Execution execution;
    const DelaunayComplex complex = buildDelaunayComplex(set.points, execution);
    EXPECT_TRUE(std::is_sorted(complex.tetrahedra.begin(), complex.tetrahedra.end()));
  }
}

TEST(DelaunayComplex, StopsSoonAfterACancelOnAnyNumberOfThreads)
{
  const std::vector<Vec3> points = largePointSets(testSeed())[0].points;
  for (const unsigned threads : { 1U, 2U })
  {
    const CancelToken token;
    double reached = 0.0;
    Execution execution(threads, token,
      [&](std::string_view, double fraction)
      {
        reached = fraction;
        if (fraction > 0.3)
        {
          token.cancel();
        }
      });
    execution.plan({ { "triangulate", 1.0 } });
    EXPECT_THROW(buildDelaunayComplex(points, execution), Cancelled);
    EXPECT_GT(reached, 0.3);
    EXPECT_LT(reached, 0.75) << "with " << threads << " threads";
  }
}

} // namespace
} // namespace scan::test
