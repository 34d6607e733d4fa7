// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/align.h"

#include "tests/geometry/point_fixtures.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iostream>
#include <map>

namespace scan::test
{
namespace
{

/// The inverse of a rotation and a shift.
Affine inverse(const Affine& motion)
{
  Affine back{ { motion.x.x, motion.y.x, motion.z.x }, { motion.x.y, motion.y.y, motion.z.y },
    { motion.x.z, motion.y.z, motion.z.z }, {} };
  back.origin = back.direction(motion.origin) * -1.0;
  return back;
}

Affine motionOf(double x, double y, double z, const Vec3& shift)
{
  Affine motion = rotationBy(x, y, z, 1.0);
  motion.origin = shift;
  return motion;
}

std::vector<Vec3> moved(std::vector<Vec3> points, const Affine& motion)
{
  std::ranges::for_each(points, [&](Vec3& p) { p = motion.point(p); });
  return points;
}

double largestError(const std::vector<Vec3>& points, const Affine& found, const Affine& expected)
{
  double largest = 0.0;
  for (const Vec3& p : points)
  {
    largest = std::max(largest, length(found.point(p) - expected.point(p)));
  }
  return largest;
}

/// A lopsided ring, which cannot slide on itself.
std::vector<Vec3> ring(std::uint64_t seed)
{
  std::vector<Vec3> points = torusTruth(20000, seed).points;
  std::ranges::for_each(points,
    [](Vec3& p) {
      p = { p.x, 0.7 * p.y, p.z + 0.2 * std::sin(2.0 * std::atan2(p.y, p.x)) };
    });
  return points;
}

std::vector<Vec3> where(std::vector<Vec3> points, bool (*isIn)(const Vec3&))
{
  std::erase_if(points, [&](const Vec3& p) { return !isIn(p); });
  return points;
}

const Affine kMotion = motionOf(0.03, -0.05, 0.08, { 0.02, -0.03, 0.04 });

AlignResult run(const std::vector<Vec3>& moving, const std::vector<Vec3>& fixed,
  const AlignOptions& options = {}, unsigned threads = 2)
{
  Execution execution(threads);
  return align(moving, fixed, options, execution);
}

TEST(Align, RecoversAKnownMotionFromAPartialOverlap)
{
  const std::vector<Vec3> all = ring(pointSeed());
  const std::vector<Vec3> fixed = where(all, [](const Vec3& p) { return p.x < 0.5; });
  const std::vector<Vec3> target = where(all, [](const Vec3& p) { return p.x > -0.5; });
  const std::vector<Vec3> moving = moved(target, inverse(kMotion));
  const AlignResult result = run(moving, fixed);
  const double error = largestError(moving, result.motion, kMotion);
  std::cout << "largest error " << error << " after " << result.iterations << " iterations\n";
  EXPECT_LT(error, 1e-6 * 2.7); // of the size of the model
  EXPECT_TRUE(result.isSettled);
  EXPECT_LT(result.rms, 1e-9);
  EXPECT_GT(result.used, result.samples / 5);
  EXPECT_LT(result.used, result.samples);
  EXPECT_NEAR(result.angleDegrees, 2.0 * std::atan(std::sqrt(0.0098)) * 180.0 / 3.14159265, 1e-3);
}

TEST(Align, NeedsAQuarterOfTheScanInCommon)
{
  const std::vector<Vec3> all = ring(pointSeed());
  const std::vector<Vec3> fixed = where(all, [](const Vec3& p) { return p.x < 0.5; });
  const std::vector<Vec3> target = where(all, [](const Vec3& p) { return p.x > 0.2; });
  const std::vector<Vec3> moving = moved(target, inverse(kMotion));
  const AlignResult result = run(moving, fixed);
  EXPECT_LT(largestError(moving, result.motion, kMotion), 1e-6) << "SCAN_TEST_SEED=" << pointSeed();
}

TEST(Align, BringsOtherSamplesOfTheSameSurfaceTogether)
{
  const std::vector<Vec3> fixed = where(ring(1), [](const Vec3& p) { return p.x < 0.5; });
  const std::vector<Vec3> target = where(ring(2), [](const Vec3& p) { return p.x > -0.5; });
  const std::vector<Vec3> moving = moved(target, inverse(kMotion));
  const AlignResult result = run(moving, fixed);
  EXPECT_LT(largestError(moving, result.motion, kMotion), 0.001); // the spacing is 0.026
  EXPECT_LT(result.rms, 0.001);
}

TEST(Align, PicksAloneGiveAFirstPlacement)
{
  const Affine far = motionOf(0.9, 0.2, -0.7, { 5.0, 6.0, -7.0 });
  const std::vector<Vec3> target = ring(1);
  const std::vector<Vec3> moving = moved(target, inverse(far));
  AlignOptions options;
  options.fit = false;
  for (const std::size_t i : { 10U, 2000U, 9000U, 15000U })
  {
    options.from.push_back(moving[i]);
    options.onto.push_back(target[i]);
  }
  const AlignResult exact = run(moving, target, options);
  EXPECT_LT(largestError(moving, exact.motion, far), 1e-12);
  EXPECT_LT(exact.pairRms, 1e-12);
  EXPECT_EQ(exact.samples, 0U);

  options.onto[1] = options.onto[1] + Vec3{ 0.05, 0.0, 0.03 }; // a hand is not exact
  const AlignResult rough = run(moving, target, options);
  EXPECT_GT(rough.pairRms, 0.01);
  EXPECT_GT(largestError(moving, rough.motion, far), 0.01);
  options.fit = true;
  EXPECT_LT(largestError(moving, run(moving, target, options).motion, far), 1e-6);
}

TEST(Align, RefusesPairsThatDecideNothing)
{
  const std::vector<Vec3> points = ring(1);
  const auto expectRefused = [&](std::vector<Vec3> from, std::vector<Vec3> onto)
  {
    try
    {
      run(points, points, { .from = std::move(from), .onto = std::move(onto) });
      ADD_FAILURE() << "accepted";
    }
    catch (const Error& error)
    {
      EXPECT_EQ(error.code(), ErrorCode::badParameter) << error.what();
    }
  };
  const std::vector<Vec3> line{ { 0, 0, 0 }, { 1, 1, 1 }, { 2, 2, 2 }, { 5, 5, 5 } };
  const std::vector<Vec3> triangle{ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
  expectRefused(line, triangle);
  expectRefused(triangle, line);
  expectRefused({ { 0, 0, 0 }, { 1, 0, 0 } }, { { 0, 0, 0 }, { 1, 0, 0 } });
  expectRefused(triangle, { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } });
  expectRefused(std::vector<Vec3>(3), std::vector<Vec3>(3));
}

TEST(Align, IsTheSameOnAnyNumberOfThreads)
{
  const std::vector<Vec3> fixed = ring(1);
  const std::vector<Vec3> moving = moved(ring(2), inverse(kMotion));
  const AlignResult one = run(moving, fixed, {}, 1);
  const AlignResult three = run(moving, fixed, {}, 3);
  EXPECT_EQ(one.motion.point(moving[7]), three.motion.point(moving[7]));
  EXPECT_EQ(one.rms, three.rms);
}

TEST(Align, LeavesASphereWhereItIsAlone)
{
  const std::vector<Vec3> fixed = sphereTruth(5000, 1).points;
  const AlignResult result =
    run(moved(sphereTruth(5000, 2).points, motionOf(0, 0, 0, { 0.1, 0, 0 })), fixed);
  EXPECT_NEAR(result.motion.origin.x, -0.1, 0.01);
}

TEST(Align, TakesDegenerateInput)
{
  const std::vector<Vec3> fixed = ring(1);
  for (const auto& [name, points] : degenerateClouds())
  {
    for (const bool isMoving : { true, false })
    {
      try
      {
        const AlignResult result = run(isMoving ? points : fixed, isMoving ? fixed : points);
        EXPECT_TRUE(std::isfinite(result.motion.origin.x)) << name;
      }
      catch (const Error& error)
      {
        EXPECT_EQ(error.code(), ErrorCode::badInput) << name;
      }
    }
  }
}

TEST(Align, RefusesAndStops)
{
  expectRefusesAndStops([](const std::vector<Vec3>& points, Execution& execution)
    { align(points, points, {}, execution); });
}

/// The published registration of the bunny scans: the list rotates by the transposed quaternion.
TEST(Align, FindsThePublishedPlaceOfABunnyScan)
{
  const std::string folder = sharedFile("02_range_scans/stanford_bunny/data/");
  std::map<std::string, Affine> places;
  std::ifstream list(folder + "bun.conf");
  for (std::string word; list >> word;)
  {
    if (word == "bmesh")
    {
      Vec3 shift;
      double x = 0.0;
      double y = 0.0;
      double z = 0.0;
      double w = 0.0;
      list >> word >> shift.x >> shift.y >> shift.z >> x >> y >> z >> w;
      places[word] = rotationBy(-x, -y, -z, w);
      places[word].origin = shift;
    }
  }
  std::vector<Vec3> fixed = pointsOfFile(folder + "bun000.ply");
  std::vector<Vec3> target = pointsOfFile(folder + "bun045.ply");
  if (places.empty() || fixed.empty() || target.empty())
  {
    GTEST_SKIP() << "no " << folder;
  }
  for (std::vector<Vec3>* points : { &fixed, &target })
  {
    std::erase_if(*points, [](const Vec3& p) { return std::abs(p.x) > 1.0; }); // lists of indices
  }
  target = moved(target, places["bun045.ply"]);
  const Affine off = motionOf(0.05, 0.1, -0.03, { 0.004, -0.006, 0.003 });
  const std::vector<Vec3> moving = moved(target, off);
  const AlignResult result = run(moving, fixed);
  const double error = largestError(moving, result.motion, inverse(off));
  std::cout << "from " << result.angleDegrees << " degrees and " << 1000.0 * result.shift
            << " mm off: at most " << 1000.0 * error << " mm from the published place, rms "
            << 1000.0 * result.rms << " mm\n";
  EXPECT_LT(error, 0.0003); // metres; the published scans are 0.2 mm from their merged surface
  EXPECT_LT(result.rms, 0.0002);
}

} // namespace
} // namespace scan::test
