// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/mesh.h"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <random>
#include <vector>

namespace scan::bench
{

/// A bumpy tube around a trefoil knot, points in random order with noise of a tenth of the mean
/// spacing along the normal: a scan without any favourable order or regularity.
inline std::vector<Vec3> knotScan(std::size_t count)
{
  constexpr double kTurn = 2.0 * std::numbers::pi;
  constexpr double kArea = 8700.0; // of the tube, about
  std::mt19937_64 random(1998);
  const auto uniform = [&] { return std::ldexp(static_cast<double>(random() >> 11), -53); };
  const auto centre = [](double t)
  {
    const double r = 10.0 * (2.0 + std::cos(3.0 * t));
    return Vec3{ r * std::cos(2.0 * t), r * std::sin(2.0 * t), 10.0 * std::sin(3.0 * t) };
  };
  const auto length = [](const Vec3& v) { return std::sqrt(dot(v, v)); };
  const double noise = 0.1 * std::sqrt(kArea / static_cast<double>(count));
  std::vector<Vec3> points;
  points.reserve(count);
  while (points.size() < count)
  {
    const double t = kTurn * uniform();
    const double angle = kTurn * uniform();
    constexpr double kStep = 1e-4;
    const Vec3 tangent = (centre(t + kStep) - centre(t - kStep)) * (0.5 / kStep);
    const Vec3 bend = centre(t + kStep) + centre(t - kStep) - centre(t) * 2.0;
    const Vec3 binormal = cross(tangent, bend);
    const Vec3 normal = cross(binormal, tangent);
    const double radius =
      4.0 * (1.0 + 0.1 * std::sin(9.0 * t) + 0.06 * std::sin(7.0 * angle + 23.0 * t));
    constexpr double kLongestTangent = 69.0; // rejection keeps the density even along the knot
    if (uniform() * kLongestTangent > length(tangent))
    {
      continue;
    }
    const double r = radius + noise * (uniform() + uniform() + uniform() - 1.5) * 2.0;
    points.push_back(centre(t) + normal * (r * std::cos(angle) / length(normal)) +
      binormal * (r * std::sin(angle) / length(binormal)));
  }
  return points;
}

} // namespace scan::bench
