// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/point_normals.h"

#include "tests/geometry/point_fixtures.h"

#include <algorithm>
#include <cmath>

namespace scan::test
{
namespace
{

using Orient = PointNormalOptions::Orient;

PointNormalResult run(
  const std::vector<Vec3>& points, const PointNormalOptions& options = {}, unsigned threads = 2)
{
  Execution execution(threads);
  return pointNormals(points, options, execution);
}

/// The share of normals on the side of the true ones.
template <class Normal>
double agreement(
  const std::vector<Vec3>& points, const PointNormalResult& result, const Normal& normal)
{
  double right = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    right += dot(result.normals[i], normal(points[i])) > 0.0 ? 1.0 : 0.0;
  }
  return right / static_cast<double>(points.size());
}

Vec3 normalOfPlate(const Vec3& p)
{
  const double r = std::hypot(p.x, p.y);
  Vec3 sum;
  const auto add = [&](bool isThere, const Vec3& normal) { sum = isThere ? sum + normal : sum; };
  constexpr double kOn = 1e-6;
  add(std::abs(r - 0.6) < 1e-4, Vec3{ -p.x / r, -p.y / r, 0.0 });
  add(std::abs(p.z) < kOn, { 0, 0, -1 });
  add(std::abs(p.z - 1.0) < kOn, { 0, 0, 1 });
  add(std::abs(std::abs(p.x) - 2.0) < kOn, { p.x > 0.0 ? 1.0 : -1.0, 0, 0 });
  add(std::abs(std::abs(p.y) - 2.0) < kOn, { 0, p.y > 0.0 ? 1.0 : -1.0, 0 });
  return unitVector(sum);
}

TEST(PointNormals, PointOutward)
{
  const std::uint64_t seed = pointSeed();
  for (const Truth& truth : { sphereTruth(20000, seed), torusTruth(20000, seed) })
  {
    const PointNormalResult result = run(truth.points);
    EXPECT_GE(agreement(truth.points, result, truth.normal), 0.999) << truth.name;
    double angles = 0.0;
    for (std::size_t i = 0; i < truth.points.size(); ++i)
    {
      EXPECT_NEAR(length(result.normals[i]), 1.0, 1e-12);
      angles += std::acos(std::min(1.0, dot(result.normals[i], truth.normal(truth.points[i]))));
    }
    EXPECT_LT(angles / static_cast<double>(truth.points.size()), 0.03) << "SCAN_TEST_SEED=" << seed;
    EXPECT_EQ(result.parts, 1U);
    EXPECT_EQ(result.openParts, 0U);
    EXPECT_EQ(result.undecided, 0U);
  }
  const std::vector<Vec3> plate = pointsOfFile(sampleFile("plate_hole.xyz"));
  EXPECT_GE(agreement(plate, run(plate), normalOfPlate), 0.999);
}

TEST(PointNormals, AgreeOnANoisyScan)
{
  const std::uint64_t seed = pointSeed();
  const Truth truth = torusTruth(20000, seed);
  Random random(seed);
  std::vector<Vec3> points = truth.points;
  std::ranges::for_each(points, [&](Vec3& p) { p = p + noise(random, 0.25 * truth.spacing); });
  EXPECT_GE(agreement(points, run(points), truth.normal), 0.999) << "SCAN_TEST_SEED=" << seed;
}

TEST(PointNormals, OfEveryPartPointOutward)
{
  Truth truth = sphereTruth(5000, 1);
  for (const Vec3& p : sphereTruth(5000, 2).points)
  {
    truth.points.push_back(p * 0.5 + Vec3{ 5.0, 0.0, 0.0 });
  }
  const auto normal = [](const Vec3& p) { return p.x > 2.0 ? p - Vec3{ 5.0, 0.0, 0.0 } : p; };
  const PointNormalResult result = run(truth.points);
  EXPECT_EQ(agreement(truth.points, result, normal), 1.0);
  EXPECT_EQ(result.parts, 2U);
}

TEST(PointNormals, OfASheetPointUp)
{
  const std::vector<Vec3> points = sheetTruth(10000, 1).points;
  const PointNormalResult result = run(points);
  EXPECT_EQ(agreement(points, result, [](const Vec3&) { return Vec3{ 0, 0, 1 }; }), 1.0);
  EXPECT_EQ(result.openParts, 1U);
}

TEST(PointNormals, PointToTheViewpoint)
{
  const std::vector<Vec3> points = sphereTruth(5000, 1).points;
  const Vec3 viewpoint{ 0.1, 0.2, 0.3 }; // inside
  const PointNormalResult result =
    run(points, { .orient = Orient::toward, .viewpoint = viewpoint });
  EXPECT_EQ(agreement(points, result, [&](const Vec3& p) { return viewpoint - p; }), 1.0);
}

TEST(PointNormals, AreTheSameOnAnyNumberOfThreads)
{
  const std::vector<Vec3> points = torusTruth(70000, 1).points;
  EXPECT_EQ(run(points, {}, 1).normals, run(points, {}, 3).normals);
}

TEST(PointNormals, TakeDegenerateInput)
{
  for (const auto& [name, points] : degenerateClouds())
  {
    for (const auto orient : { Orient::outward, Orient::toward, Orient::none })
    {
      const PointNormalResult result = run(points, { .orient = orient });
      ASSERT_EQ(result.normals.size(), points.size()) << name;
      std::size_t undecided = 0;
      for (const Vec3& normal : result.normals)
      {
        const bool isUnit = std::abs(length(normal) - 1.0) < 1e-9;
        EXPECT_TRUE(isUnit || normal == Vec3{}) << name;
        undecided += isUnit ? 0 : 1;
      }
      EXPECT_EQ(undecided, result.undecided) << name;
      if (name == "line" || name == "equal" || points.size() < 3)
      {
        EXPECT_EQ(undecided, points.size()) << name;
      }
      if (name == "plane" || name == "three")
      {
        EXPECT_EQ(undecided, 0U) << name;
      }
    }
  }
}

TEST(PointNormals, RefuseAndStop)
{
  expectRefusesAndStops([](const std::vector<Vec3>& points, Execution& execution)
    { pointNormals(points, {}, execution); });
}

} // namespace
} // namespace scan::test
