// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/spacing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

using namespace scan;

namespace
{

std::vector<Vec3> randomPoints(std::size_t n, unsigned seed)
{
  std::mt19937 random(seed);
  const auto unit = [&] { return static_cast<double>(random()) / 4294967296.0; };
  std::vector<Vec3> points(n);
  for (Vec3& p : points)
  {
    p = { unit(), unit(), 0.3 * unit() };
  }
  return points;
}

double meanSpacingByForce(const std::vector<Vec3>& points)
{
  double sum = 0.0;
  for (const Vec3& p : points)
  {
    double best = std::numeric_limits<double>::infinity();
    for (const Vec3& q : points)
    {
      best = p == q ? best : std::min(best, dot(p - q, p - q));
    }
    sum += std::sqrt(best);
  }
  return sum / static_cast<double>(points.size());
}

} // namespace

TEST(Spacing, OfAGridIsItsStep)
{
  std::vector<Vec3> points;
  for (int i = 0; i < 900; ++i)
  {
    points.push_back({ 0.25 * (i % 30), 0.25 * (i / 30), 7.0 });
  }
  EXPECT_DOUBLE_EQ(meanSpacing(points), 0.25);
}

TEST(Spacing, AgreesWithBruteForce)
{
  const std::vector<Vec3> points = randomPoints(2000, 1);
  EXPECT_NEAR(meanSpacing(points), meanSpacingByForce(points), 1e-12);
}

TEST(Spacing, SampleStandsForAllWithinTwoPercent)
{
  const std::vector<Vec3> points = randomPoints(200000, 2);
  const double density = 200000.0 / 0.3;
  // a Poisson process in space: Gamma(4/3) (4/3 pi density)^(-1/3), a little more at the walls
  const double expected = 0.892980 * std::cbrt(3.0 / (4.0 * std::numbers::pi * density));
  EXPECT_NEAR(meanSpacing(points), expected, 0.02 * expected);
}

TEST(Spacing, DoesNotDependOnOrderDuplicatesOrBrokenPoints)
{
  std::vector<Vec3> points = randomPoints(30000, 3);
  const double spacing = meanSpacing(points);
  points.insert(points.end(), points.begin(), points.begin() + 5000);
  points.push_back({ std::nan(""), 0.0, 0.0 });
  points.push_back({ 0.0, std::numeric_limits<double>::infinity(), 0.0 });
  std::shuffle(points.begin(), points.end(), std::mt19937(4));
  EXPECT_EQ(meanSpacing(points), spacing);
}

TEST(Spacing, FarStrayPointsDoNotMatter)
{
  std::vector<Vec3> points = randomPoints(5000, 5);
  const double spacing = meanSpacing(points);
  points.push_back({ 1e6, 0.0, 0.0 });
  points.push_back({ 0.0, -1e9, 0.0 });
  EXPECT_NEAR(meanSpacing(points), spacing, 1e-9 * spacing);
}

TEST(Spacing, IsZeroWithoutTwoDistinctPoints)
{
  EXPECT_EQ(meanSpacing({}), 0.0);
  EXPECT_EQ(meanSpacing(std::vector<Vec3>(100, Vec3{ 1, 2, 3 })), 0.0);
  EXPECT_EQ(meanSpacing(std::vector<Vec3>{ { 0, 0, 0 }, { 0, 3, 4 } }), 5.0);
}
