// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "data/samples.h"

#include "data/limb_scan_truth.h"
#include "data/multiview_scan_truth.h"
#include "filters/geometry/local_plane.h"
#include "filters/geometry/mesh_checks.h"
#include "filters/geometry/wrap.h"

#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <iterator>

using namespace scan;

TEST(Samples, FilesAreWhatTheProgramWrites)
{
  for (const samples::Sample& sample : samples::makeSamples())
  {
    std::ifstream file(std::string(SCAN_DATA_DIR) + '/' + sample.name, std::ios::binary);
    const std::string bytes(std::istreambuf_iterator<char>(file), {});
    EXPECT_TRUE(bytes == sample.bytes)
      << sample.name << " differs; run scan_make_samples " << SCAN_DATA_DIR;
  }
}

void expectNoise(
  const std::vector<Vec3>& points, double noise, const std::function<double(const Vec3&)>& distance)
{
  double sum = 0.0;
  double squares = 0.0;
  for (const Vec3& p : points)
  {
    const double from = distance(p);
    EXPECT_LT(std::abs(from), 5.0 * noise);
    sum += from;
    squares += from * from;
  }
  const double n = static_cast<double>(points.size());
  EXPECT_LT(std::abs(sum / n), 0.02 * noise);
  // less than the noise along the ray, as most rays are oblique
  EXPECT_LT(std::sqrt(squares / n), noise);
  EXPECT_GT(std::sqrt(squares / n), 0.6 * noise);
}

TEST(Samples, ScansLieOnTheTrueSurfaceButForTheirNoise)
{
  expectNoise(samples::simulateScan(), samples::kScanNoise, truth::distance);
  expectNoise(samples::simulateLimbScan(), samples::kLimbNoise, truth::limb::distance);
}

TEST(Samples, ScanCoversTheWholeSurfaceEyeIncluded)
{
  const std::vector<Vec3> points = samples::simulateScan();
  for (int i = 0; i < 36; ++i)
  {
    const double angle = 3.14159265358979 * i / 18.0;
    for (double z = -4.0; z <= 4.0; z += 1.0)
    {
      const Vec3 wall = { truth::kEyeRadius * std::cos(angle), truth::kEyeRadius * std::sin(angle),
        z };
      ASSERT_NEAR(truth::distance(wall), 0.0, 1e-9);
      double nearest = 1e9;
      for (const Vec3& p : points)
      {
        nearest = std::min(nearest, dot(p - wall, p - wall));
      }
      EXPECT_LT(std::sqrt(nearest), 1.0) << i << ' ' << z;
    }
  }
}

TEST(Samples, TruthIsADistance)
{
  using namespace truth;
  EXPECT_DOUBLE_EQ(distance({ 18.0, 0.0, 20.0 }), 12.0); // above the flat top
  EXPECT_DOUBLE_EQ(distance({ 0.0, 0.0, 0.0 }), kEyeRadius);
  EXPECT_DOUBLE_EQ(distance({ -30.0, 0.0, 0.0 }), 6.0);
  EXPECT_DOUBLE_EQ(distance({ 75.0, 0.0, 0.0 }), 3.0);
  EXPECT_DOUBLE_EQ(distance({ 30.0, 0.0, 7.0 }), -1.0);
  // beside the rounded edge: from its circle's centre at radius 20, height 4
  EXPECT_NEAR(distance({ -26.0, 0.0, 12.0 }), 10.0 - kRounding, 1e-12);
}

TEST(Samples, LimbIsOneSmoothSolid)
{
  using namespace truth::limb;
  // above the knee and at the tips of the toes one ball alone decides
  EXPECT_NEAR(distance(kKnee + Vec3{ 0.0, 0.0, 51.0 }), 1.0, 1e-6);
  EXPECT_NEAR(distance(kKnee + Vec3{ 0.0, 0.0, 49.5 }), -0.5, 1e-6);
  EXPECT_NEAR(distance(kToes + Vec3{ 0.0, 21.25, 0.0 }), 0.25, 1e-6);
  // beside the shin, where balls of 54 to 33 touch the surface
  const Vec3 shin = kAnkle - kCalf;
  const double slope = 21.0 / length(shin);
  const Vec3 along = shin * (1.0 / length(shin));
  const Vec3 outward = Vec3{ std::sqrt(1.0 - slope * slope), 0.0, 0.0 } + along * slope;
  EXPECT_NEAR(distance(kCalf + shin * 0.5 + outward * (43.5 + 0.5)), 0.5, 1e-6);
  Execution execution;
  const MeshReport report = describeMesh(wrap(samples::simulateLimbScan(), {}, execution).surface);
  EXPECT_TRUE(report.isClosed && report.isManifold);
  EXPECT_EQ(report.eulerCharacteristic, 2);
}
