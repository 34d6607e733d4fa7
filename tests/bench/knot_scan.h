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

/// A point of the trefoil knot, t from 0 to 2 pi.
inline Vec3 knotCentre(double t)
{
  const double r = 10.0 * (2.0 + std::cos(3.0 * t));
  return { r * std::cos(2.0 * t), r * std::sin(2.0 * t), 10.0 * std::sin(3.0 * t) };
}

/// A bumpy tube around a trefoil knot, points in random order with noise of a tenth of the mean
/// spacing along the normal: a scan without any favourable order or regularity.
inline std::vector<Vec3> knotScan(std::size_t count)
{
  constexpr double kTurn = 2.0 * std::numbers::pi;
  constexpr double kArea = 8700.0; // of the tube, about
  std::mt19937_64 random(1998);
  const auto uniform = [&] { return std::ldexp(static_cast<double>(random() >> 11), -53); };
  const auto length = [](const Vec3& v) { return std::sqrt(dot(v, v)); };
  const double noise = 0.1 * std::sqrt(kArea / static_cast<double>(count));
  std::vector<Vec3> points;
  points.reserve(count);
  while (points.size() < count)
  {
    const double t = kTurn * uniform();
    const double angle = kTurn * uniform();
    constexpr double kStep = 1e-4;
    const Vec3 tangent = (knotCentre(t + kStep) - knotCentre(t - kStep)) * (0.5 / kStep);
    const Vec3 bend = knotCentre(t + kStep) + knotCentre(t - kStep) - knotCentre(t) * 2.0;
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
    points.push_back(knotCentre(t) + normal * (r * std::cos(angle) / length(normal)) +
      binormal * (r * std::sin(angle) / length(binormal)));
  }
  return points;
}

/// The same tube as a closed mesh of rows × columns quads, two triangles each, without noise.
inline TriMesh knotMesh(Index rows, Index columns)
{
  constexpr double kTurn = 2.0 * std::numbers::pi;
  const auto unit = [](const Vec3& v) { return v * (1.0 / std::sqrt(dot(v, v))); };
  TriMesh mesh;
  for (Index i = 0; i < rows; ++i)
  {
    constexpr double kStep = 1e-4;
    const double t = kTurn * i / rows;
    const Vec3 tangent = knotCentre(t + kStep) - knotCentre(t - kStep);
    const Vec3 binormal =
      unit(cross(tangent, knotCentre(t + kStep) + knotCentre(t - kStep) - knotCentre(t) * 2.0));
    const Vec3 normal = unit(cross(binormal, tangent));
    for (Index j = 0; j < columns; ++j)
    {
      const double angle = kTurn * j / columns;
      const double r =
        4.0 * (1.0 + 0.1 * std::sin(9.0 * t) + 0.06 * std::sin(7.0 * angle + 23.0 * t));
      mesh.points.push_back(
        knotCentre(t) + normal * (r * std::cos(angle)) + binormal * (r * std::sin(angle)));
      const auto at = [&](Index row, Index column)
      { return (row % rows) * columns + column % columns; };
      mesh.triangles.push_back({ at(i, j), at(i, j + 1), at(i + 1, j + 1) });
      mesh.triangles.push_back({ at(i, j), at(i + 1, j + 1), at(i + 1, j) });
    }
  }
  return mesh;
}

} // namespace scan::bench
