// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/analysis/view_framing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

using namespace scan;

namespace
{

/// The box that the points cover in the picture; 1 is its half width and half height.
struct Cover
{
  double left = 9, right = -9, bottom = 9, top = -9;
};

Cover project(const std::vector<Vec3>& points, const ViewFrame& frame, const ViewOptions& options)
{
  Vec3 back = frame.position - frame.target;
  const double distance = std::sqrt(dot(back, back));
  back = back * (1.0 / distance);
  const Vec3 right = cross(frame.up, back);
  Cover cover;
  for (const Vec3& p : points)
  {
    const Vec3 q = p - frame.position;
    const double ahead = -dot(q, back);
    EXPECT_GT(ahead, 0.0);
    const double half = options.viewAngle > 0.0
      ? ahead * std::tan(options.viewAngle * std::numbers::pi / 360.0)
      : frame.halfHeight;
    const double x = dot(q, right) / (half * options.aspect);
    const double y = dot(q, frame.up) / half;
    cover = { std::min(cover.left, x), std::max(cover.right, x), std::min(cover.bottom, y),
      std::max(cover.top, y) };
  }
  return cover;
}

std::vector<Vec3> box(unsigned seed)
{
  std::mt19937 random(seed);
  const auto unit = [&] { return static_cast<double>(random()) / 4294967296.0; };
  const Vec3 size = { 0.1 + unit(), 0.1 + unit(), 0.1 + unit() };
  const Vec3 corner = { 10.0 * unit(), -10.0 * unit(), unit() };
  std::vector<Vec3> points(50);
  for (Vec3& p : points)
  {
    p = corner + Vec3{ size.x * unit(), size.y * unit(), size.z * unit() };
  }
  return points;
}

} // namespace

TEST(ViewFraming, FillsThePictureUpToTheMarginInEitherProjection)
{
  for (unsigned seed = 1; seed <= 50; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const std::vector<Vec3> points = box(seed);
    for (const double angle : { 0.0, 25.0, 60.0 })
    {
      const ViewOptions options = {
        .towards = { 0.7, -1.0, 0.5 }, .up = { 0, 0, 1 }, .viewAngle = angle, .margin = 0.1
      };
      const Cover cover = project(points, frameView(points, options), options);
      const double widest = std::max({ -cover.left, cover.right, -cover.bottom, cover.top });
      EXPECT_LE(widest, 0.9 + 1e-9);
      // a wide angle is held back from a deep model
      EXPECT_GE(widest, angle > 30.0 ? 0.4 : 0.9 - 1e-9);
      if (angle < 30.0)
      {
        const bool isWide = std::max(-cover.left, cover.right) > 0.9 - 1e-9;
        EXPECT_NEAR(isWide ? cover.left + cover.right : cover.bottom + cover.top, 0.0, 1e-9);
      }
    }
  }
}

TEST(ViewFraming, ShowsASinglePointAndALineOfSight)
{
  for (const double angle : { 0.0, 25.0 })
  {
    const ViewOptions options = { .viewAngle = angle };
    const std::vector<Vec3> point = { { 5, 6, 7 } };
    const ViewFrame frame = frameView(point, options);
    EXPECT_TRUE(frame.target == point[0]);
    EXPECT_GT(frame.position.z, 7.0);
    EXPECT_GT(frame.halfHeight, 0.5);
    const std::vector<Vec3> line = { { 0, 0, -1 }, { 0, 0, 1 } };
    EXPECT_GT(frameView(line, options).position.z, 1.0);
  }
}
