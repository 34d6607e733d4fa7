// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "data/samples.h"

#include "data/limb_scan_truth.h"
#include "data/multiview_scan_truth.h"
#include "data/splitmix.h"
#include "data/truth_measures.h"

#include <numbers>
#include <optional>

namespace samples
{
namespace
{

using scan::Vec3;

constexpr double kGrazing = 0.2;      // cosine below which a real camera sees nothing
constexpr double kHitDistance = 1e-9; // mm

/// Twelve cameras around a solid; lengths in millimetres.
struct Scanner
{
  Vec3 target;
  double cameraDistance; ///< from the target
  double reach;          ///< from the target to the farthest point of the solid, at least
  double pitch;          ///< between neighbouring rays at the target
  int halfWidth;         ///< rays on each side of the middle
  double noise;          ///< standard deviation along the ray
  std::uint64_t seed;
};

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
template <class Distance>
std::optional<double> castRay(
  const Scanner& scanner, const Vec3& eye, const Vec3& direction, Distance&& distanceAt)
{
  double along = scanner.cameraDistance - scanner.reach; // in front of everything
  while (along < scanner.cameraDistance + scanner.reach)
  {
    const double distance = distanceAt(eye + direction * along);
    if (distance < kHitDistance)
    {
      return along;
    }
    along += distance;
  }
  return std::nullopt;
}

/// @param distanceAt of a point outside, at most how far it is from the solid; zero on its surface
template <class Distance>
std::vector<Vec3> seenPoints(const Scanner& scanner, Distance&& distanceAt)
{
  SplitMix random(scanner.seed);
  std::vector<Vec3> points;
  for (const Vec3& towards : cameraDirections())
  {
    const Vec3 eye = scanner.target + towards * scanner.cameraDistance;
    const Vec3 right = normalized(cross({ 0.1, 0.9, 0.4 }, towards));
    const Vec3 up = cross(towards, right);
    for (int row = -scanner.halfWidth; row <= scanner.halfWidth; ++row)
    {
      for (int column = -scanner.halfWidth; column <= scanner.halfWidth; ++column)
      {
        const Vec3 aim =
          scanner.target + right * (scanner.pitch * column) + up * (scanner.pitch * row);
        const Vec3 ray = normalized(aim - eye);
        const std::optional<double> range = castRay(scanner, eye, ray, distanceAt);
        if (range &&
          -dot(normalized(truth::differences(eye + ray * *range, distanceAt)), ray) > kGrazing)
        {
          points.push_back(eye + ray * (*range + scanner.noise * random.normal()));
        }
      }
    }
  }
  return points;
}

} // namespace

std::vector<Vec3> simulateScan()
{
  const Scanner scanner{ .target = { 24.0, 0.0, 0.0 },
    .cameraDistance = 260.0,
    .reach = 80.0,
    .pitch = 0.85,
    .halfWidth = 80,
    .noise = kScanNoise,
    .seed = 12 };
  return seenPoints(scanner, truth::distance);
}

std::vector<Vec3> simulateLimbScan()
{
  const Scanner scanner{ .target = { 0.0, 45.0, 215.0 },
    .cameraDistance = 900.0,
    .reach = 350.0,
    .pitch = 3.0,
    .halfWidth = 110,
    .noise = kLimbNoise,
    .seed = 7 };
  return seenPoints(scanner, truth::limb::field);
}

} // namespace samples
