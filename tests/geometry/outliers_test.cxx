// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/outliers.h"

#include "tests/geometry/point_fixtures.h"

#include <algorithm>
#include <cmath>
#include <iostream>

namespace scan::test
{
namespace
{

OutlierResult find(const std::vector<Vec3>& points, unsigned threads = 2)
{
  Execution execution(threads);
  return findOutliers(points, everywhere(points), {}, execution);
}

enum class Density
{
  even,
  falling, ///< smoothly to a tenth, from one end to the other
  broken   ///< ten times as many points on one half
};

/// A surface, and behind its points others at random in a box enlarged by 10 %.
struct Scene
{
  Truth truth;
  std::size_t surfacePoints = 0;
};

Scene sceneOf(Truth truth, Density density, double share, std::uint64_t seed)
{
  Random random(seed);
  std::erase_if(truth.points,
    [&](const Vec3& p)
    {
      const double part = std::clamp((p.x + 1.35) / 2.7, 0.0, 1.0);
      const double chance = density == Density::even ? 1.0
        : density == Density::falling                ? std::pow(10.0, -part)
        : p.x > 0.0                                  ? 0.1
                                                     : 1.0;
      return random.unit() >= chance;
    });
  Scene scene{ std::move(truth), 0 };
  std::vector<Vec3>& points = scene.truth.points;
  scene.surfacePoints = points.size();
  Vec3 low = points.front();
  Vec3 high = low;
  for (const Vec3& p : points)
  {
    low = { std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z) };
    high = { std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z) };
  }
  const Vec3 size = (high - low) * 1.1;
  const Vec3 corner = (low + high) * 0.5 - size * 0.5;
  const auto strays = static_cast<std::size_t>(share * static_cast<double>(points.size()));
  for (std::size_t i = 0; i < strays; ++i)
  {
    const double x = random.unit();
    const double y = random.unit();
    const double z = random.unit();
    points.push_back({ corner.x + size.x * x, corner.y + size.y * y, corner.z + size.z * z });
  }
  return scene;
}

/// Precision counts every point of the surface as right, every other as stray. Recall is of the
/// strays that are farther than six spacings from the surface, where they do not pass for noise;
/// the spacing is that of the sparsest part.
TEST(FindOutliers, IsPreciseAndComplete)
{
  const std::uint64_t seed = pointSeed();
  for (const auto density : { Density::even, Density::falling, Density::broken })
  {
    for (const double share : { 0.01, 0.05 })
    {
      for (Truth truth :
        { sphereTruth(30000, seed), torusTruth(30000, seed), sheetTruth(30000, seed) })
      {
        const Scene scene = sceneOf(truth, density, share, seed);
        const double spacing = truth.spacing * (density == Density::even ? 1.0 : std::sqrt(10.0));
        const OutlierResult found = find(scene.truth.points);
        double right = 0.0;
        double all = 0.0;
        double far = 0.0;
        double farFound = 0.0;
        for (std::size_t i = 0; i < scene.truth.points.size(); ++i)
        {
          const bool isStray = i >= scene.surfacePoints;
          all += found.isStray[i];
          right += isStray ? found.isStray[i] : 0;
          if (isStray && truth.distance(scene.truth.points[i]) > 6.0 * spacing)
          {
            far += 1.0;
            farFound += found.isStray[i];
          }
        }
        const double precision = right / all;
        const double recall = far > 0.0 ? farFound / far : 1.0;
        std::cout << truth.name << ", density " << static_cast<int>(density) << ", "
                  << 100.0 * share << " % stray: precision " << precision << ", recall " << recall
                  << " of " << far << "\n";
        EXPECT_GE(precision, 0.95) << "SCAN_TEST_SEED=" << seed;
        // where the torus is ten times thinner at once, 5 % of strays are hardly thinner than it
        EXPECT_GE(recall, density == Density::broken && share > 0.01 ? 0.7 : 0.9)
          << "SCAN_TEST_SEED=" << seed;
      }
    }
  }
}

TEST(FindOutliers, LeavesCleanScansAlone)
{
  const std::uint64_t seed = pointSeed();
  for (const Truth& truth :
    { sphereTruth(20000, seed), torusTruth(20000, seed), sheetTruth(20000, seed) })
  {
    const OutlierResult found = find(truth.points);
    EXPECT_LE(found.single + found.together, 2U) << truth.name << " SCAN_TEST_SEED=" << seed;
  }
  for (const char* const sample :
    { "torus.xyz", "plate_hole.xyz", "helix.xyz", "monkey_saddle.xyz" })
  {
    const OutlierResult found = find(pointsOfFile(sampleFile(sample)));
    EXPECT_EQ(found.single + found.together, 0U) << sample;
  }
}

TEST(FindOutliers, FindsClumpsFarFromTheRest)
{
  Random random(pointSeed());
  for (const int size : { 1, 2, 5, 12, 20, 40 })
  {
    std::vector<Vec3> points = sphereTruth(10000, 1).points;
    for (int i = 0; i < size; ++i)
    {
      points.push_back(Vec3{ 2.0, 0.0, 0.0 } + noise(random, 0.02));
    }
    const OutlierResult found = find(points);
    EXPECT_EQ(found.single + found.together, static_cast<std::size_t>(size));
    EXPECT_EQ(std::ranges::count(found.isStray.end() - size, found.isStray.end(), 1), size);
  }
}

TEST(FindOutliers, KeepsPartsThatAreLargeEnough)
{
  std::vector<Vec3> points = sphereTruth(5000, 1).points;
  for (const Vec3& p : sphereTruth(300, 2).points)
  {
    points.push_back(p * 0.25 + Vec3{ 3.0, 0.0, 0.0 });
  }
  const OutlierResult found = find(points);
  EXPECT_EQ(found.single + found.together, 0U);
}

TEST(FindOutliers, FindsTheStrayPointOfTheEarScan)
{
  const std::string path = sharedFile("02_range_scans/stanford_bunny/data/ear_back.ply");
  std::vector<Vec3> points = pointsOfFile(path);
  if (points.empty())
  {
    GTEST_SKIP() << "no " << path;
  }
  std::erase_if(points, [](const Vec3& p) { return std::abs(p.x) > 1.0; }); // lists of indices
  Execution execution;
  const Neighbours places(points, execution);
  const OutlierResult found = find(points);
  std::size_t far = 0;
  for (Index place = 0; place < places.size(); ++place)
  {
    std::vector<Neighbour> near;
    places.nearest(places[place], 2, near);
    if (near[1].squaredDistance > 0.01 * 0.01) // 10 mm: 18 spacings
    {
      ++far;
      EXPECT_EQ(found.isStray[places.pointsAt(place).front()], 1);
    }
  }
  EXPECT_GE(far, 1U);
  EXPECT_LT(found.single + found.together, 50U); // of 32,193
}

TEST(FindOutliers, IsTheSameOnAnyNumberOfThreadsAndInTheRegionOnly)
{
  const Scene scene = sceneOf(torusTruth(70000, 1), Density::falling, 0.03, 5);
  const std::vector<Vec3>& points = scene.truth.points;
  const OutlierResult all = find(points, 1);
  EXPECT_EQ(find(points, 3).isStray, all.isStray);
  std::vector<std::uint8_t> inRegion(points.size());
  std::ranges::transform(points, inRegion.begin(), [](const Vec3& p) { return p.y > 0 ? 1 : 0; });
  Execution execution(2);
  const OutlierResult part = findOutliers(points, inRegion, {}, execution);
  EXPECT_GT(part.single + part.together, 0U);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    EXPECT_EQ(part.isStray[i], all.isStray[i] * inRegion[i]);
  }
}

TEST(FindOutliers, TakesDegenerateInput)
{
  for (const auto& [name, points] : degenerateClouds())
  {
    const OutlierResult found = find(points);
    EXPECT_EQ(found.isStray.size(), points.size()) << name;
    EXPECT_TRUE(found.single + found.together == 0 || name == "two scales") << name;
  }
}

TEST(FindOutliers, RefusesAndStops)
{
  expectRefusesAndStops([](const std::vector<Vec3>& points, Execution& execution)
    { findOutliers(points, everywhere(points), {}, execution); });
}

} // namespace
} // namespace scan::test
