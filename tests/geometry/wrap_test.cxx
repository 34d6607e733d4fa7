// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/wrap.h"

#include "data/multiview_scan_truth.h"
#include "data/samples.h"
#include "filters/base/error.h"
#include "filters/geometry/mesh_checks.h"
#include "tests/geometry/complex_corpus.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

namespace scan::test
{
namespace
{

using Mode = WrapOptions::Mode;

WrapResult run(
  const std::vector<Vec3>& points, const WrapOptions& options = {}, unsigned threads = 0)
{
  Execution execution(threads);
  return wrap(points, options, execution);
}

std::vector<Vec3> spherePoints(std::size_t count, double noise)
{
  std::mt19937_64 random(testSeed());
  std::normal_distribution<double> normal;
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < count; ++i)
  {
    const Vec3 p{ normal(random), normal(random), normal(random) };
    points.push_back(p * ((1.0 + noise * normal(random)) / std::sqrt(dot(p, p))));
  }
  return points;
}

TEST(Wrap, ManifoldWhateverThePoints)
{
  for (std::uint64_t round = 0; round < 4; ++round)
  {
    for (const PointSet& set : pointSets(testSeed() + round))
    {
      for (const Mode mode : { Mode::automatic, Mode::classic })
      {
        SCOPED_TRACE(set.name + (mode == Mode::classic ? " classic" : " automatic") +
          ", SCAN_TEST_SEED=" + std::to_string(set.seed));
        const WrapResult result = run(set.points, { .mode = mode });
        const MeshReport mesh = describeMesh(result.surface);
        EXPECT_TRUE(mesh.isManifold || result.surface.triangles.empty());
        EXPECT_EQ(result.surface.points.size(), result.scanPointIds.size());
        for (std::size_t v = 0; v < result.scanPointIds.size(); ++v)
        {
          ASSERT_EQ(result.surface.points[v], set.points[result.scanPointIds[v]]);
        }
        if (mode == Mode::automatic && !result.report.isOpen && !result.surface.triangles.empty())
        {
          EXPECT_TRUE(mesh.isClosed);
          EXPECT_TRUE(mesh.isOriented);
          EXPECT_GT(mesh.volume.value_or(-1.0), 0.0); // outward
        }
      }
    }
  }
}

TEST(Wrap, ReportAccountsForEveryPoint)
{
  std::vector<Vec3> points = spherePoints(2000, 0.0);
  points.insert(points.end(), points.begin(), points.begin() + 100);
  const WrapReport report = run(points).report;
  EXPECT_EQ(report.pointsRead, 2100U);
  EXPECT_EQ(report.duplicatesMerged, 100U);
  EXPECT_EQ(report.pointsOnSurface, 2000U);
  EXPECT_EQ(report.boundaryTriangles, 2 * 2000U - 4);
  EXPECT_EQ(report.sheetTriangles, 0U);
}

TEST(Wrap, SphereIsClosedOutwardAndOfTheRightVolume)
{
  const WrapResult result = run(spherePoints(20000, 0.0));
  const MeshReport mesh = describeMesh(result.surface);
  EXPECT_TRUE(mesh.isClosed);
  EXPECT_TRUE(mesh.isManifold);
  EXPECT_EQ(mesh.genus, 0);
  EXPECT_NEAR(mesh.volume.value_or(0.0), 4.18879, 0.01);
}

TEST(Wrap, SameResultOnAnyNumberOfThreads)
{
  const std::vector<Vec3> points = spherePoints(30000, 0.01);
  for (const Mode mode : { Mode::automatic, Mode::classic })
  {
    const WrapResult one = run(points, { .mode = mode }, 1);
    const WrapResult two = run(points, { .mode = mode }, 2);
    EXPECT_EQ(one.surface.triangles, two.surface.triangles);
    EXPECT_EQ(one.scanPointIds, two.scanPointIds);
    EXPECT_EQ(one.lines, two.lines);
  }
}

TEST(Wrap, SampleScanLiesOnTheTrueSurface)
{
  const std::vector<Vec3> points = samples::simulateScan();
  const WrapResult result = run(points);
  const MeshReport mesh = describeMesh(result.surface);
  EXPECT_TRUE(mesh.isClosed);
  ASSERT_FALSE(mesh.components.empty());
  EXPECT_EQ(mesh.components.front().genus, 1);
  EXPECT_GE(result.report.pointsOnSurface, 0.999 * static_cast<double>(points.size()));
  double sum2 = 0.0;
  double largest = 0.0;
  for (const Triangle& t : result.surface.triangles)
  {
    const auto& p = result.surface.points;
    const double distance = std::abs(truth::distance((p[t[0]] + p[t[1]] + p[t[2]]) * (1.0 / 3.0)));
    sum2 += distance * distance;
    largest = std::max(largest, distance);
  }
  const double rms = std::sqrt(sum2 / static_cast<double>(result.surface.triangles.size()));
  EXPECT_LT(rms, samples::kScanNoise); // triangles average the noise of their points
  EXPECT_LT(largest, 10 * samples::kScanNoise);
}

TEST(Wrap, StrayPointIsNotDrawnIntoTheSurface)
{
  std::vector<Vec3> points = spherePoints(5000, 0.0);
  points.push_back({ 5.0, 0.0, 0.0 });
  const WrapResult result = run(points);
  EXPECT_EQ(result.report.pointsOnSurface, 5000U);
  EXPECT_LT(describeMesh(result.surface).longestEdge, 0.5);
}

TEST(Wrap, RobustFitStaysClosed)
{
  const WrapResult result = run(spherePoints(5000, 0.02), { .fit = WrapOptions::Fit::robust });
  EXPECT_TRUE(describeMesh(result.surface).isClosed);
}

TEST(Wrap, CancelIsAnsweredInEveryPhase)
{
  const std::vector<Vec3> points = spherePoints(60000, 0.01);
  for (const Mode mode : { Mode::automatic, Mode::classic })
  {
    const WrapOptions options{ .mode = mode };
    for (const Phase& phase : wrapPhases(options))
    {
      CancelToken token;
      bool reached = false;
      Execution execution(2, token,
        [&](std::string_view name, double)
        {
          if (name == phase.name)
          {
            reached = true;
            token.cancel();
          }
        });
      execution.plan(wrapPhases(options));
      EXPECT_THROW(wrap(points, options, execution), Cancelled) << phase.name;
      EXPECT_TRUE(reached) << phase.name;
    }
  }
}

TEST(Wrap, CancelFromAnotherThreadIsPrompt)
{
  const std::vector<Vec3> points = spherePoints(200000, 0.001);
  for (const int milliseconds : { 5, 50, 150, 300 })
  {
    CancelToken token;
    Execution execution(0, token);
    std::chrono::steady_clock::time_point raised;
    std::thread canceller(
      [&]
      {
        std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
        raised = std::chrono::steady_clock::now();
        token.cancel();
      });
    EXPECT_THROW(wrap(points, {}, execution), Cancelled);
    const auto answered = std::chrono::steady_clock::now();
    canceller.join();
    EXPECT_LT(std::chrono::duration<double>(answered - raised).count(), 0.5);
  }
}

} // namespace
} // namespace scan::test
