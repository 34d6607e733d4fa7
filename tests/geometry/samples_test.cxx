// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "data/samples.h"

#include "data/multiview_scan_truth.h"

#include <gtest/gtest.h>

#include <fstream>
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

TEST(Samples, ScanLiesOnTheTrueSurfaceButForItsNoise)
{
  const std::vector<Vec3> points = samples::simulateScan();
  double sum = 0.0;
  double squares = 0.0;
  for (const Vec3& p : points)
  {
    const double distance = truth::distance(p);
    EXPECT_LT(std::abs(distance), 5.0 * samples::kScanNoise);
    sum += distance;
    squares += distance * distance;
  }
  const double n = static_cast<double>(points.size());
  EXPECT_LT(std::abs(sum / n), 0.02 * samples::kScanNoise);
  // less than the noise along the ray, as most rays are oblique
  EXPECT_LT(std::sqrt(squares / n), samples::kScanNoise);
  EXPECT_GT(std::sqrt(squares / n), 0.6 * samples::kScanNoise);
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
