// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/polygon.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <random>
#include <string>

using namespace scan;

namespace
{

std::vector<Triangle> trianglesOf(
  const std::vector<Vec3>& points, const std::vector<Index>& corners)
{
  std::vector<Triangle> triangles;
  appendPolygon(triangles, points, corners);
  return triangles;
}

std::vector<Triangle> trianglesOf(const std::vector<Vec3>& points)
{
  std::vector<Index> corners(points.size());
  std::iota(corners.begin(), corners.end(), Index(0));
  return trianglesOf(points, corners);
}

Vec3 areaVector(const std::vector<Vec3>& points, const Triangle& t)
{
  return cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]) * 0.5;
}

double length(const Vec3& v)
{
  return std::sqrt(dot(v, v));
}

/// The areas of the triangles, each counted positive.
double filledArea(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles)
{
  double area = 0.0;
  for (const Triangle& t : triangles)
  {
    area += length(areaVector(points, t));
  }
  return area;
}

/// Twice the area of a polygon in space, by its edges.
double borderArea(const std::vector<Vec3>& points)
{
  Vec3 area;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    area = area + cross(points[i], points[(i + 1) % points.size()]) * 0.5;
  }
  return length(area);
}

const std::vector<Vec3> kSquare = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } };

} // namespace

TEST(Polygon, IsTheFanOfItsFirstCornerWhenConvex)
{
  EXPECT_EQ(trianglesOf(kSquare), (std::vector<Triangle>{ { 0, 1, 2 }, { 0, 2, 3 } }));
  EXPECT_EQ(trianglesOf(kSquare, { 0, 1, 2 }), (std::vector<Triangle>{ { 0, 1, 2 } }));
  EXPECT_TRUE(trianglesOf(kSquare, { 0, 1 }).empty());
  EXPECT_TRUE(trianglesOf(kSquare, {}).empty());
}

TEST(Polygon, OfAnArrowheadStaysInItsBorder)
{
  // the fan around the first corner would cover the notch at the third
  const std::vector<Vec3> arrow = { { 0, 0, 0 }, { 4, 2, 0 }, { 1, 2, 0 }, { 0, 4, 0 } };
  const std::vector<Vec3> turned = { arrow[1], arrow[2], arrow[3], arrow[0] };
  for (const auto& points : { arrow, turned })
  {
    const std::vector<Triangle> triangles = trianglesOf(points);
    ASSERT_EQ(triangles.size(), 2U);
    EXPECT_DOUBLE_EQ(filledArea(points, triangles), borderArea(points));
  }
}

TEST(Polygon, OfAStarInAnyPositionIsFilledAsItTurns)
{
  constexpr unsigned kSeed = 4711;
  SCOPED_TRACE("seed " + std::to_string(kSeed));
  std::mt19937 random(kSeed);
  std::uniform_real_distribution<double> coordinate(-1.0, 1.0);
  for (int round = 0; round < 200; ++round)
  {
    const Vec3 u = { coordinate(random), coordinate(random), coordinate(random) };
    const Vec3 w = { coordinate(random), coordinate(random), coordinate(random) };
    const std::size_t count = 5 + static_cast<std::size_t>(round);
    std::vector<Vec3> points;
    for (std::size_t i = 0; i < count; ++i)
    {
      const double angle = 2.0 * std::numbers::pi * double(i) / double(count);
      const double radius = 1.1 + coordinate(random);
      points.push_back(u * (radius * std::cos(angle)) + w * (radius * std::sin(angle)));
    }
    const std::vector<Triangle> triangles = trianglesOf(points);
    EXPECT_EQ(triangles.size(), count - 2);
    EXPECT_NEAR(filledArea(points, triangles), borderArea(points), 1e-9);
    EXPECT_TRUE(std::ranges::all_of(
      triangles, [&](const Triangle& t) { return dot(areaVector(points, t), cross(u, w)) > 0.0; }))
      << round;
  }
}

TEST(Polygon, KeepsAHoleThatIsCutInAlongAnEdge)
{
  std::vector<Vec3> points = { { 0, 0, 2 }, { 6, 0, 2 }, { 6, 6, 2 }, { 0, 6, 2 } };
  points.insert(points.end(), { { 2, 2, 2 }, { 2, 4, 2 }, { 4, 4, 2 }, { 4, 2, 2 } });
  std::vector<Index> corners = { 0, 1, 2, 3, 0, 4, 5, 6, 7, 4 };
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    std::ranges::rotate(corners, corners.begin() + 1);
    const std::vector<Triangle> triangles = trianglesOf(points, corners);
    EXPECT_EQ(triangles.size(), 8U) << i;
    EXPECT_DOUBLE_EQ(filledArea(points, triangles), 36.0 - 4.0) << i;
  }
}

TEST(Polygon, KeepsAHoleWhoseSlitHasACornerOnOneSide)
{
  std::vector<Vec3> points = { { 0, 0, 2 }, { 6, 0, 2 }, { 6, 6, 2 }, { 0, 6, 2 } };
  points.insert(points.end(), { { 2, 2, 2 }, { 2, 4, 2 }, { 4, 4, 2 }, { 4, 2, 2 }, { 1, 1, 2 } });
  const std::vector<Triangle> triangles = trianglesOf(points, { 0, 1, 2, 3, 0, 4, 5, 6, 7, 4, 8 });
  EXPECT_DOUBLE_EQ(filledArea(points, triangles), 36.0 - 4.0);
}

TEST(Polygon, HasNoFlatTriangleWhereItNeedsNone)
{
  const std::vector<Vec3> points = { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 2, 2, 0 },
    { 0, 2, 0 } };
  const std::vector<Triangle> triangles = trianglesOf(points);
  EXPECT_EQ(triangles.size(), 3U);
  EXPECT_TRUE(std::ranges::all_of(
    triangles, [&](const Triangle& t) { return length(areaVector(points, t)) > 0.1; }));
}

TEST(Polygon, KeepsCornersThatLieAboveOthers)
{
  const std::vector<Vec3> points = { { 0, 0, 0 }, { 4, 0, 0 }, { 4, 4, 0 }, { 2, 1, 0 },
    { 2, 1, 5 }, { 0, 4, 0 } };
  std::vector<bool> isUsed(points.size());
  for (const Triangle& t : trianglesOf(points))
  {
    isUsed[t[0]] = isUsed[t[1]] = isUsed[t[2]] = true;
  }
  EXPECT_EQ(std::ranges::count(isUsed, true), 6);
}

TEST(Polygon, WithoutAnInsideBecomesAFan)
{
  const std::vector<Vec3> line = { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 3, 0, 0 } };
  EXPECT_EQ(trianglesOf(line).size(), 2U);
  // a line whose area is not 0 after rounding
  EXPECT_EQ(
    trianglesOf({ { 1, 5, 0 }, { 0, 0, 0 }, { -0.06, -0.3, 0 }, { 0.48, 2.4, 0 } }).size(), 2U);
  // a pentagram crosses itself
  std::vector<Vec3> crossing;
  for (int i = 0; i < 5; ++i)
  {
    const double angle = 4.0 * std::numbers::pi * i / 5.0 + 0.1;
    crossing.push_back({ std::cos(angle), std::sin(angle), 0 });
  }
  EXPECT_EQ(trianglesOf(crossing).size(), 3U);
  // corners that are not known yet, and coordinates that are no numbers
  EXPECT_EQ(trianglesOf(kSquare, { 0, 1, 2, 7 }).size(), 2U);
  std::vector<Vec3> broken = kSquare;
  broken[3].x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(trianglesOf(broken).size(), 2U);
}

TEST(Polygon, OfAnyCornersBecomesTrianglesOfThem)
{
  constexpr unsigned kSeed = 99;
  SCOPED_TRACE("seed " + std::to_string(kSeed));
  std::mt19937 random(kSeed);
  std::uniform_int_distribution<int> place(0, 3);
  for (int round = 0; round < 20000; ++round)
  {
    std::vector<Vec3> points(3 + static_cast<std::size_t>(round % 9));
    for (Vec3& p : points)
    {
      p = { 0.1 * place(random), 0.3 * place(random), round % 2 * 0.7 * place(random) };
    }
    std::vector<Index> corners(points.size() + 1);
    for (Index& corner : corners)
    {
      corner = static_cast<Index>(random() % points.size());
    }
    const std::vector<Triangle> triangles = trianglesOf(points, corners);
    ASSERT_FALSE(triangles.empty()) << round;
    ASSERT_LE(triangles.size(), corners.size() - 2) << round;
    ASSERT_TRUE(std::ranges::all_of(triangles,
      [&](const Triangle& t)
      {
        return std::ranges::all_of(
          t, [&](Index i) { return std::ranges::find(corners, i) != corners.end(); });
      }))
      << round;
  }
}

TEST(Polygon, OfManyCornersIsNoLongWork)
{
  // quadratic work would take minutes
  constexpr int kMany = 50000;
  constexpr double kStep = std::numbers::pi / kMany;
  std::vector<Vec3> comb = { { 0, -1, 0 }, { kMany, -1, 0 } };
  std::vector<Vec3> crescent;
  std::vector<Vec3> zigzag;
  for (int i = kMany; i > 0; --i)
  {
    comb.push_back({ double(i), 0, 0 });
    comb.push_back({ i - 0.5, 3, 0 });
    crescent.push_back({ std::cos(kStep * i), std::sin(kStep * i), 0 });
    zigzag.push_back({ double(i), double(i % 2), 0 });
  }
  comb.push_back({ 0, 0, 0 });
  crescent.push_back({ 1, 0, 0 });
  for (int i = 1; i <= kMany; ++i)
  {
    zigzag.push_back({ double(i), i % 2 + 0.25, 0 });
  }
  for (int i = 1; i < kMany; ++i)
  {
    crescent.push_back({ std::cos(kStep * i), 0.9 * std::sin(kStep * i), 0 });
  }
  for (const auto& points : { comb, crescent, zigzag })
  {
    const std::vector<Triangle> triangles = trianglesOf(points);
    EXPECT_EQ(triangles.size(), points.size() - 2);
    EXPECT_NEAR(filledArea(points, triangles), borderArea(points), 1e-6);
  }
}
