// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "data/truth_measures.h"
#include "filters/geometry/mesh.h"

#include <algorithm>
#include <cmath>

/// The solid behind limb_scan.ply: a leg from the knee to the toes, which point along y; genus 0,
/// smooth but for the curvature where parts begin to blend. Lengths in millimetres.
namespace truth::limb
{

/// What two balls and the cone that touches both enclose.
struct Part
{
  scan::Vec3 from;
  scan::Vec3 to;
  double fromRadius;
  double toRadius;
};

inline constexpr scan::Vec3 kKnee{ 0.0, 0.0, 400.0 };
inline constexpr scan::Vec3 kCalf{ 0.0, -20.0, 290.0 };
inline constexpr scan::Vec3 kAnkle{ 0.0, 0.0, 85.0 };
inline constexpr scan::Vec3 kHeel{ 0.0, -38.0, 34.0 };
inline constexpr scan::Vec3 kBall{ 5.0, 115.0, 30.0 };
inline constexpr scan::Vec3 kToes{ -2.0, 165.0, 21.0 };
inline constexpr Part kParts[] = { { kKnee, kCalf, 50.0, 54.0 }, { kCalf, kAnkle, 54.0, 33.0 },
  { kAnkle, kHeel, 33.0, 31.0 }, { kAnkle, kBall, 33.0, 30.0 }, { kHeel, kBall, 31.0, 30.0 },
  { kBall, kToes, 30.0, 21.0 } };
inline constexpr double kBlend = 16.0; ///< parts blend where their distances differ by less

/// Signed distance to the surface of a part, exact to rounding.
inline double partDistance(const Part& part, const scan::Vec3& p)
{
  const scan::Vec3 axis = part.to - part.from;
  const double length = std::sqrt(dot(axis, axis));
  const scan::Vec3 way = p - part.from;
  const double along = dot(way, axis) / length;
  const double across = std::sqrt(std::max(dot(way, way) - along * along, 0.0));
  return outlineDistance(along, across, length, part.fromRadius, part.toRadius);
}

/// Zero on the surface, negative inside; never more than the distance from it outside.
inline double field(const scan::Vec3& p)
{
  double all = partDistance(kParts[0], p);
  for (std::size_t i = 1; i < std::size(kParts); ++i)
  {
    const double part = partDistance(kParts[i], p);
    const double both = std::max(kBlend - std::abs(all - part), 0.0);
    all = std::min(all, part) - both * both / (4.0 * kBlend);
  }
  return all;
}

inline scan::Vec3 gradient(const scan::Vec3& p)
{
  return differences(p, field) * (0.5 / kDifferenceStep);
}

/// Signed distance to the solid's surface, negative inside, of points within a millimetre of it: to
/// a thousandth of the distance.
inline double distance(const scan::Vec3& p)
{
  scan::Vec3 foot = p;
  for (int i = 0; i < 3; ++i)
  {
    const scan::Vec3 up = gradient(foot);
    foot = foot - up * (field(foot) / dot(up, up));
  }
  const scan::Vec3 way = p - foot;
  return std::copysign(std::sqrt(dot(way, way)), field(p));
}

} // namespace truth::limb
