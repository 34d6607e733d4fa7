// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/thin.h"

#include "tests/geometry/point_fixtures.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

namespace scan::test
{
namespace
{

using By = ThinOptions::By;
using Kept = std::vector<std::uint8_t>;

constexpr By kAll[] = { By::random, By::spacing, By::grid, By::curvature };

std::ptrdiff_t countOf(const Kept& kept)
{
  return std::ranges::count(kept, 1);
}

Kept thinAll(const std::vector<Vec3>& points, const ThinOptions& options, unsigned threads = 1)
{
  Execution execution(threads);
  return thin(points, everywhere(points), options, execution);
}

std::vector<Vec3> select(const std::vector<Vec3>& points, const Kept& kept, std::uint8_t value)
{
  std::vector<Vec3> chosen;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (kept[i] == value)
    {
      chosen.push_back(points[i]);
    }
  }
  return chosen;
}

double nearestDistance(const std::vector<Vec3>& points, const Vec3& at)
{
  double nearest = HUGE_VAL;
  for (const Vec3& p : points)
  {
    nearest = std::min(nearest, dot(p - at, p - at));
  }
  return std::sqrt(nearest);
}

TEST(ThinRandom, KeepsTheExactShareForAnyPercentage)
{
  const std::vector<Vec3> points = sphereTruth(997, 1).points;
  for (const By by : { By::random, By::curvature })
  {
    for (const double percent : { 0.0, 0.01, 0.1, 12.34, 25.0, 50.0, 99.9, 100.0 })
    {
      const Kept kept = thinAll(points, { .by = by, .keep = percent });
      EXPECT_EQ(countOf(kept), std::llround(997 * percent / 100.0)) << percent;
    }
  }
}

/// Every one of 40 points is kept in a quarter of the choices, and every pair in as many as
/// sampling without replacement means.
TEST(ThinRandom, IsFairToPointsAndPairs)
{
  constexpr int kPoints = 40;
  constexpr int kKept = 10;
  constexpr int kSeeds = 20000;
  const std::vector<Vec3> points(kPoints);
  std::vector<int> single(kPoints, 0);
  std::map<std::pair<int, int>, int> pairs;
  for (int seed = 0; seed < kSeeds; ++seed)
  {
    const Kept kept =
      thinAll(points, { .by = By::random, .keep = 25.0, .seed = static_cast<std::uint64_t>(seed) });
    ASSERT_EQ(countOf(kept), kKept);
    for (int i = 0; i < kPoints; ++i)
    {
      for (int j = 0; j < i && kept[i] != 0; ++j)
      {
        pairs[{ i, j }] += kept[j];
      }
      single[i] += kept[i];
    }
  }
  // Inclusion counts sum to a constant: (n - 1) / n of the variance p (1 - p) is left to each, so
  // that the sum below has the distribution of chi square with n - 1 degrees of freedom.
  constexpr double p = static_cast<double>(kKept) / kPoints;
  double chi = 0.0;
  for (const int times : single)
  {
    chi += std::pow(times - kSeeds * p, 2) / (kSeeds * p * (1.0 - p)) * (kPoints - 1) / kPoints;
  }
  // 39 degrees of freedom: 72.1 is exceeded by chance once in 1000, 17.3 undershot as rarely
  EXPECT_LT(chi, 72.1);
  EXPECT_GT(chi, 17.3);
  // 780 pairs, nearly independent: mean 780, deviation about sqrt(2 * 780) = 39.5; five of these
  constexpr double q = p * (kKept - 1) / (kPoints - 1);
  double chiOfPairs = 0.0;
  for (int i = 0; i < kPoints; ++i)
  {
    for (int j = 0; j < i; ++j)
    {
      chiOfPairs += std::pow(pairs[{ i, j }] - kSeeds * q, 2) / (kSeeds * q * (1.0 - q));
    }
  }
  EXPECT_NEAR(chiOfPairs, 780.0, 200.0);
  RecordProperty("chi", std::to_string(chi));
  RecordProperty("chiOfPairs", std::to_string(chiOfPairs));
}

TEST(Random, BoundsAreFairWhereTwoToTheSixtyFourIsNoMultiple)
{
  Random random(pointSeed());
  const std::uint64_t bound = (std::uint64_t{ 1 } << 63U) + (std::uint64_t{ 1 } << 62U); // 3/4
  int lowThird = 0;
  constexpr int kDraws = 30000;
  for (int i = 0; i < kDraws; ++i)
  {
    const std::uint64_t drawn = random.below(bound);
    ASSERT_LT(drawn, bound);
    lowThird += drawn < bound / 3 ? 1 : 0;
  }
  // a plain remainder would draw the low third half the time; deviation 82
  EXPECT_NEAR(lowThird, kDraws / 3, 410) << "SCAN_TEST_SEED=" << pointSeed();
}

TEST(Thin, SameSeedSamePointsAnotherSeedOthers)
{
  const std::vector<Vec3> points = torusTruth(3000, 1).points;
  for (const By by : { By::random, By::curvature })
  {
    EXPECT_EQ(thinAll(points, { .by = by }), thinAll(points, { .by = by }));
    EXPECT_NE(thinAll(points, { .by = by }), thinAll(points, { .by = by, .seed = 2 }));
  }
}

TEST(Thin, IsTheSameOnAnyNumberOfThreads)
{
  const std::vector<Vec3> points = torusTruth(70000, 1).points; // more than one step of a loop
  for (const By by : kAll)
  {
    const ThinOptions options{ .by = by, .spacing = 0.02 };
    EXPECT_EQ(thinAll(points, options, 1), thinAll(points, options, 3));
  }
}

TEST(ThinBySpacing, LeavesNoneTooNearAndNoGap)
{
  std::vector<Vec3> points = torusTruth(2000, pointSeed()).points;
  points.insert(points.end(), points.begin(), points.begin() + 100); // repeated points
  for (const double spacing : { 0.0, 0.01, 0.1, 0.5, 10.0 })
  {
    const Kept kept = thinAll(points, { .by = By::spacing, .spacing = spacing });
    const std::vector<Vec3> chosen = select(points, kept, 1);
    for (std::size_t i = 0; i < chosen.size(); ++i)
    {
      for (std::size_t j = 0; j < i; ++j)
      {
        ASSERT_GE(length(chosen[i] - chosen[j]), spacing);
        ASSERT_NE(chosen[i], chosen[j]);
      }
    }
    for (const Vec3& dropped : select(points, kept, 0))
    {
      const double nearest = nearestDistance(chosen, dropped);
      ASSERT_TRUE(nearest < spacing || nearest == 0.0) << "SCAN_TEST_SEED=" << pointSeed();
    }
  }
}

TEST(ThinBySpacing, DoesNotDependOnTheOrderOfThePoints)
{
  std::vector<Vec3> points = torusTruth(2000, 3).points;
  const auto chosen = [&]
  {
    std::vector<Vec3> kept =
      select(points, thinAll(points, { .by = By::spacing, .spacing = 0.1 }), 1);
    std::ranges::sort(kept,
      [](const Vec3& a, const Vec3& b)
      { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); });
    return kept;
  };
  const std::vector<Vec3> before = chosen();
  std::ranges::reverse(points);
  EXPECT_EQ(chosen(), before);
}

TEST(ThinByGrid, KeepsThePointNearestToTheMeanOfEveryCube)
{
  const std::vector<Vec3> points = torusTruth(3000, pointSeed()).points;
  constexpr double kSide = 0.2;
  Vec3 low = points.front();
  for (const Vec3& p : points)
  {
    low = { std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z) };
  }
  std::map<std::tuple<int, int, int>, std::vector<std::size_t>> cubes;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const Vec3 d = (points[i] - low) * (1.0 / kSide);
    cubes[{ static_cast<int>(d.x), static_cast<int>(d.y), static_cast<int>(d.z) }].push_back(i);
  }
  const Kept kept = thinAll(points, { .by = By::grid, .spacing = kSide });
  EXPECT_EQ(countOf(kept), static_cast<std::ptrdiff_t>(cubes.size()));
  for (const auto& [cube, members] : cubes)
  {
    Vec3 mean;
    for (const std::size_t i : members)
    {
      mean = mean + points[i] * (1.0 / static_cast<double>(members.size()));
    }
    const auto nearest = std::ranges::min_element(
      members, {}, [&](std::size_t i) { return length(points[i] - mean); });
    EXPECT_EQ(kept[*nearest], 1) << "SCAN_TEST_SEED=" << pointSeed();
  }
}

/// A plate and a quarter of a cylinder beside it, with a crease of a right angle at the far end.
TEST(ThinByCurvature, KeepsEdgesAndBendsDenser)
{
  Random random(pointSeed());
  std::vector<Vec3> points;
  std::vector<int> part; // 0 flat, 1 bent, 2 crease
  while (points.size() < 12000)
  {
    const double along = 4.0 * random.unit();
    const double y = random.unit();
    if (along < 1.0)
    {
      points.push_back({ 0.0, y, along });
      part.push_back(along < 0.05 ? 2 : 0);
    }
    else if (along < 3.0)
    {
      points.push_back({ along - 1.0, y, 0.0 });
      part.push_back(along < 1.05 ? 2 : along > 2.9 ? 1 : 0);
    }
    else
    {
      const double angle = along - 3.0;
      points.push_back({ 2.0 + std::sin(angle), y, 1.0 - std::cos(angle) });
      part.push_back(1);
    }
  }
  for (std::size_t i = 0; i < points.size(); ++i) // the crease is at x = 0, z = 0
  {
    part[i] = points[i].x < 0.03 && points[i].z < 0.03 ? 2 : part[i] == 2 ? 0 : part[i];
  }
  const Kept kept = thinAll(points, { .by = By::curvature, .keep = 20.0 });
  double share[3] = {};
  for (int which = 0; which < 3; ++which)
  {
    double members = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      members += part[i] == which ? 1.0 : 0.0;
      share[which] += part[i] == which ? kept[i] : 0.0;
    }
    share[which] /= members;
  }
  RecordProperty("flat", std::to_string(share[0]));
  RecordProperty("bent", std::to_string(share[1]));
  RecordProperty("crease", std::to_string(share[2]));
  EXPECT_GT(share[1], 1.8 * share[0]) << "SCAN_TEST_SEED=" << pointSeed();
  EXPECT_GT(share[2], 0.95);
  EXPECT_GT(share[0], 0.04);
}

TEST(Thin, LeavesPointsOutsideTheRegionAlone)
{
  const std::vector<Vec3> points = torusTruth(2000, 1).points;
  std::vector<std::uint8_t> inRegion(points.size());
  std::ranges::transform(points, inRegion.begin(), [](const Vec3& p) { return p.x > 0 ? 1 : 0; });
  const auto members = std::ranges::count(inRegion, 1);
  Execution execution(1);
  for (const By by : kAll)
  {
    const Kept kept = thin(points, inRegion, { .by = by, .keep = 10.0, .spacing = 0.2 }, execution);
    std::ptrdiff_t ofRegion = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      EXPECT_TRUE(inRegion[i] != 0 || kept[i] == 1);
      ofRegion += inRegion[i] * kept[i];
    }
    EXPECT_LT(ofRegion, members);
    if (by == By::random || by == By::curvature)
    {
      EXPECT_EQ(ofRegion, std::llround(0.1 * static_cast<double>(members)));
    }
  }
}

TEST(Thin, TakesDegenerateInput)
{
  for (const auto& [name, points] : degenerateClouds())
  {
    for (const By by : kAll)
    {
      const Kept kept = thinAll(points, { .by = by, .keep = 50.0, .spacing = 0.5 });
      EXPECT_EQ(kept.size(), points.size()) << name;
      EXPECT_EQ(countOf(kept) > 0, !points.empty() && (by != By::random || points.size() > 0))
        << name;
      if (name == "equal" && (by == By::spacing || by == By::grid))
      {
        EXPECT_EQ(countOf(kept), 1);
      }
    }
  }
}

TEST(Thin, RefusesAndStops)
{
  for (const By by : { By::spacing, By::curvature })
  {
    expectRefusesAndStops([by](const std::vector<Vec3>& points, Execution& execution)
      { thin(points, everywhere(points), { .by = by, .spacing = 0.1 }, execution); });
  }
}

} // namespace
} // namespace scan::test
