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

inline constexpr double kTurn = 2.0 * std::numbers::pi;

/// A bumpy tube around a trefoil knot.
class Knot
{
public:
  /// The length of the tangent at t; at most kLongestTangent.
  static double speed(double t) { return length(tangent(t)); }
  static constexpr double kLongestTangent = 69.0;

  /// @param angle around the tube
  /// @param offset from it
  static Vec3 at(double t, double angle, double offset = 0.0)
  {
    const Vec3 bend = centre(t + kStep) + centre(t - kStep) - centre(t) * 2.0;
    const Vec3 binormal = cross(tangent(t), bend);
    const Vec3 normal = cross(binormal, tangent(t));
    const double radius =
      4.0 * (1.0 + 0.1 * std::sin(9.0 * t) + 0.06 * std::sin(7.0 * angle + 23.0 * t)) + offset;
    return centre(t) + normal * (radius * std::cos(angle) / length(normal)) +
      binormal * (radius * std::sin(angle) / length(binormal));
  }

private:
  static constexpr double kStep = 1e-4;

  static double length(const Vec3& v) { return std::sqrt(dot(v, v)); }

  static Vec3 centre(double t)
  {
    const double r = 10.0 * (2.0 + std::cos(3.0 * t));
    return { r * std::cos(2.0 * t), r * std::sin(2.0 * t), 10.0 * std::sin(3.0 * t) };
  }

  static Vec3 tangent(double t) { return (centre(t + kStep) - centre(t - kStep)) * (0.5 / kStep); }
};

/// Points of the knot in random order with noise of a tenth of the mean spacing along the normal: a
/// scan without any favourable order or regularity.
inline std::vector<Vec3> knotScan(std::size_t count)
{
  constexpr double kArea = 8700.0; // of the tube, about
  std::mt19937_64 random(1998);
  const auto uniform = [&] { return std::ldexp(static_cast<double>(random() >> 11), -53); };
  const double noise = 0.1 * std::sqrt(kArea / static_cast<double>(count));
  std::vector<Vec3> points;
  points.reserve(count);
  while (points.size() < count)
  {
    const double t = kTurn * uniform();
    const double angle = kTurn * uniform();
    if (uniform() * Knot::kLongestTangent > Knot::speed(t)) // keeps the density even along the knot
    {
      continue;
    }
    points.push_back(Knot::at(t, angle, noise * (uniform() + uniform() + uniform() - 1.5) * 2.0));
  }
  return points;
}

/// The knot as a closed surface of twice as many triangles as quads along and around it; 2000 and
/// 250 make a million.
inline TriMesh knotSurface(Index along, Index around)
{
  TriMesh mesh;
  for (Index i = 0; i < along; ++i)
  {
    for (Index j = 0; j < around; ++j)
    {
      mesh.points.push_back(Knot::at(kTurn * i / along, kTurn * j / around));
      const Index next = (i + 1) % along * around;
      const Index side = (j + 1) % around;
      const Index a = i * around + j;
      mesh.triangles.push_back({ a, next + j, next + side });
      mesh.triangles.push_back({ a, next + side, i * around + side });
    }
  }
  return mesh;
}

} // namespace scan::bench
