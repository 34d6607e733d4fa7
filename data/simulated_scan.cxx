// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "data/samples.h"

#include "data/multiview_scan_truth.h"
#include "data/splitmix.h"

#include <numbers>
#include <optional>

namespace samples
{
namespace
{

using scan::Vec3;

constexpr Vec3 kTarget = { 24.0, 0.0, 0.0 };
constexpr double kCameraDistance = 260.0;
constexpr double kPitch = 0.85;       // between neighbouring rays at the target, mm
constexpr int kHalfWidth = 80;        // rays on each side of the middle
constexpr double kGrazing = 0.2;      // cosine below which a real camera sees nothing
constexpr double kHitDistance = 1e-9; // mm

Vec3 normalized(const Vec3& v)
{
  return v * (1.0 / std::sqrt(dot(v, v)));
}

/// Directions from the target to the cameras: ten around, five of them looking down and five up,
/// one above and one below, both a little oblique as hands are.
std::vector<Vec3> cameraDirections()
{
  std::vector<Vec3> directions;
  for (int i = 0; i < 10; ++i)
  {
    const double azimuth = 2.0 * std::numbers::pi * i / 10.0 + 0.1;
    directions.push_back(
      normalized({ std::cos(azimuth), std::sin(azimuth), i % 2 == 0 ? 0.7 : -0.7 }));
  }
  directions.push_back(normalized({ 0.06, 0.03, 1.0 }));
  directions.push_back(normalized({ -0.04, 0.07, -1.0 }));
  return directions;
}

/// How far along the ray the surface is: steps as long as nothing can be nearer.
std::optional<double> castRay(const Vec3& eye, const Vec3& direction)
{
  double along = kCameraDistance - 80.0; // in front of everything
  while (along < kCameraDistance + 80.0)
  {
    const double distance = truth::distance(eye + direction * along);
    if (distance < kHitDistance)
    {
      return along;
    }
    along += distance;
  }
  return std::nullopt;
}

Vec3 surfaceNormal(const Vec3& p)
{
  constexpr double step = 1e-4;
  const auto slope = [&](const Vec3& axis)
  { return truth::distance(p + axis * step) - truth::distance(p - axis * step); };
  return normalized({ slope({ 1, 0, 0 }), slope({ 0, 1, 0 }), slope({ 0, 0, 1 }) });
}

} // namespace

std::vector<Vec3> simulateScan()
{
  SplitMix random(12);
  std::vector<Vec3> points;
  for (const Vec3& towards : cameraDirections())
  {
    const Vec3 eye = kTarget + towards * kCameraDistance;
    const Vec3 right = normalized(cross({ 0.1, 0.9, 0.4 }, towards));
    const Vec3 up = cross(towards, right);
    for (int row = -kHalfWidth; row <= kHalfWidth; ++row)
    {
      for (int column = -kHalfWidth; column <= kHalfWidth; ++column)
      {
        const Vec3 aim = kTarget + right * (kPitch * column) + up * (kPitch * row);
        const Vec3 ray = normalized(aim - eye);
        const std::optional<double> range = castRay(eye, ray);
        if (range && -dot(surfaceNormal(eye + ray * *range), ray) > kGrazing)
        {
          points.push_back(eye + ray * (*range + kScanNoise * random.normal()));
        }
      }
    }
  }
  return points;
}

} // namespace samples
