// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/denoise.h"

#include "filters/geometry/spacing.h"
#include "tests/geometry/point_fixtures.h"

#include <algorithm>
#include <cmath>
#include <iostream>

namespace scan::test
{
namespace
{

DenoiseResult run(
  const std::vector<Vec3>& points, const DenoiseOptions& options, unsigned threads = 2)
{
  Execution execution(threads);
  return denoise(points, everywhere(points), options, execution);
}

template <class Distance>
double meanOf(const std::vector<Vec3>& points, const Distance& distance)
{
  double sum = 0.0;
  for (const Vec3& p : points)
  {
    sum += distance(p);
  }
  return sum / static_cast<double>(points.size());
}

double largestShift(const std::vector<Vec3>& from, const std::vector<Vec3>& to)
{
  double largest = 0.0;
  for (std::size_t i = 0; i < from.size(); ++i)
  {
    largest = std::max(largest, length(to[i] - from[i]));
  }
  return largest;
}

TEST(Denoise, ShrinksTheErrorOfTheNoisySphereThreeTimesByDefault)
{
  const std::vector<Vec3> points = pointsOfFile(sharedFile("synthetic/sphere20k_noise.xyz"));
  if (points.empty())
  {
    GTEST_SKIP() << "no synthetic/sphere20k_noise.xyz";
  }
  const auto distance = [](const Vec3& p) { return std::abs(length(p) - 1.0); };
  const double limit = 2.0 * meanSpacing(points); // the default of the operation
  const DenoiseResult result = run(points, { .maxShift = limit });
  const double before = meanOf(points, distance);
  const double after = meanOf(result.points, distance);
  std::cout << "mean distance from the sphere " << before << " -> " << after << ", ratio "
            << before / after << ", mean shift " << result.meanShift << ", largest "
            << result.largestShift << "\n";
  EXPECT_GT(before, 3.0 * after);
  EXPECT_LE(largestShift(points, result.points), limit);
}

TEST(Denoise, ShrinksTheErrorOfCurvedSurfaces)
{
  const std::uint64_t seed = pointSeed();
  for (const Truth& truth : { sphereTruth(10000, seed), torusTruth(10000, seed) })
  {
    Random random(seed);
    std::vector<Vec3> points = truth.points;
    std::ranges::for_each(points, [&](Vec3& p) { p = p + noise(random, 0.25 * truth.spacing); });
    const DenoiseResult result = run(points, { .maxShift = 2.0 * truth.spacing });
    const double ratio = meanOf(points, truth.distance) / meanOf(result.points, truth.distance);
    std::cout << truth.name << ": ratio " << ratio << "\n";
    EXPECT_GT(ratio, 2.5) << truth.name << " SCAN_TEST_SEED=" << seed;
  }
}

TEST(Denoise, HardlyMovesCleanPoints)
{
  const Truth truth = torusTruth(20000, 1);
  const DenoiseResult result = run(truth.points, { .maxShift = truth.spacing });
  EXPECT_LT(result.meanShift, 0.01 * truth.spacing);
}

/// Whatever the options, and far from the origin, too, where coordinates are rounded.
TEST(Denoise, NoPointExceedsTheLimit)
{
  const std::uint64_t seed = pointSeed();
  for (const Vec3 place : { Vec3{}, Vec3{ 5e5, -4e6, 300.0 } })
  {
    Random random(seed);
    std::vector<Vec3> points = sphereTruth(3000, seed).points;
    std::ranges::for_each(points, [&](Vec3& p) { p = place + p + noise(random, 0.05); });
    for (const double limit : { 0.0, 1e-9, 0.001, 0.02, 0.1 })
    {
      const DenoiseResult result = run(points, { .maxShift = limit, .iterations = 4 });
      const double largest = largestShift(points, result.points);
      EXPECT_LE(largest, limit) << "SCAN_TEST_SEED=" << seed;
      EXPECT_EQ(result.largestShift, largest);
      if (limit == 0.001)
      {
        EXPECT_GT(result.limited, 1000U);
        EXPECT_GT(result.meanShift, 0.9 * limit);
      }
    }
  }
}

/// The distance from the surface of the cube of half side 1.
double distanceFromCube(const Vec3& p)
{
  const Vec3 d{ std::abs(p.x) - 1.0, std::abs(p.y) - 1.0, std::abs(p.z) - 1.0 };
  const double inside = std::max({ d.x, d.y, d.z });
  return inside <= 0.0 ? -inside
                       : length({ std::max(d.x, 0.0), std::max(d.y, 0.0), std::max(d.z, 0.0) });
}

TEST(Denoise, KeepsTheEdgesOfACube)
{
  const std::uint64_t seed = pointSeed();
  Random random(seed);
  std::vector<Vec3> clean;
  while (clean.size() < 24000)
  {
    const double u = 2.0 * random.unit() - 1.0;
    const double v = 2.0 * random.unit() - 1.0;
    const double side = random.below(2) == 0 ? -1.0 : 1.0;
    const std::uint64_t axis = random.below(3);
    clean.push_back(axis == 0 ? Vec3{ side, u, v }
        : axis == 1           ? Vec3{ u, side, v }
                              : Vec3{ u, v, side });
  }
  const double spacing = std::sqrt(24.0 / 24000.0);
  const auto isAtEdge = [&](const Vec3& p)
  {
    int near = 0;
    for (const double value : { p.x, p.y, p.z })
    {
      near += std::abs(value) > 1.0 - 2.0 * spacing ? 1 : 0;
    }
    return near >= 2;
  };
  const double deviation = 0.2 * spacing;
  for (const double noiseOf : { 0.0, deviation })
  {
    std::vector<Vec3> points = clean;
    std::ranges::for_each(points, [&](Vec3& p) { p = p + noise(random, noiseOf); });
    const DenoiseResult result = run(points, { .maxShift = 2.0 * spacing });
    double before = 0.0;
    double after = 0.0;
    double atEdge = 0.0;
    for (std::size_t i = 0; i < clean.size(); ++i)
    {
      if (isAtEdge(clean[i]))
      {
        atEdge += 1.0;
        before += distanceFromCube(points[i]);
        after += distanceFromCube(result.points[i]);
      }
    }
    std::cout << "edge of a cube, noise " << noiseOf / spacing << " spacings: mean distance "
              << before / atEdge / spacing << " -> " << after / atEdge / spacing << " spacings\n";
    if (noiseOf == 0.0)
    {
      EXPECT_LT(after / atEdge, 0.5 * deviation) << "SCAN_TEST_SEED=" << seed;
    }
    else
    {
      EXPECT_LT(after, 0.8 * before) << "SCAN_TEST_SEED=" << seed;
    }
  }
}

TEST(Denoise, MovesTheRegionOnlyAndEqualPointsAlike)
{
  Random random(1);
  std::vector<Vec3> points = sphereTruth(3000, 1).points;
  std::ranges::for_each(points, [&](Vec3& p) { p = p + noise(random, 0.02); });
  points.insert(points.end(), points.begin(), points.begin() + 500);
  std::vector<std::uint8_t> inRegion(points.size());
  std::ranges::transform(points, inRegion.begin(), [](const Vec3& p) { return p.z > 0 ? 1 : 0; });
  Execution execution(1);
  const DenoiseResult result = denoise(points, inRegion, { .maxShift = 0.1 }, execution);
  std::size_t moved = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    EXPECT_TRUE(inRegion[i] != 0 || result.points[i] == points[i]);
    moved += result.points[i] != points[i] ? 1 : 0;
  }
  EXPECT_EQ(moved, result.moved);
  EXPECT_GT(moved, points.size() / 3);
  for (std::size_t i = 0; i < 500; ++i)
  {
    EXPECT_EQ(result.points[i], result.points[3000 + i]);
  }
}

TEST(Denoise, IsTheSameOnAnyNumberOfThreads)
{
  Random random(2);
  std::vector<Vec3> points = torusTruth(40000, 2).points;
  std::ranges::for_each(points, [&](Vec3& p) { p = p + noise(random, 0.005); });
  const DenoiseOptions options{ .maxShift = 0.02, .iterations = 2 };
  EXPECT_EQ(run(points, options, 1).points, run(points, options, 3).points);
}

TEST(Denoise, TakesDegenerateInput)
{
  for (const auto& [name, points] : degenerateClouds())
  {
    const DenoiseResult result = run(points, { .maxShift = 0.1 });
    ASSERT_EQ(result.points.size(), points.size()) << name;
    EXPECT_LE(largestShift(points, result.points), 0.1) << name;
    if (name == "line" || name == "plane" || points.size() < 4)
    {
      EXPECT_LT(largestShift(points, result.points), 1e-9) << name;
    }
  }
}

TEST(Denoise, RefusesAndStops)
{
  expectRefusesAndStops([](const std::vector<Vec3>& points, Execution& execution)
    { denoise(points, everywhere(points), { .maxShift = 0.1 }, execution); });
}

} // namespace
} // namespace scan::test
