// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "data/truth_measures.h"
#include "filters/geometry/mesh.h"

#include <algorithm>
#include <cmath>

/// The solid behind multiview_scan.ply: a link with one eye, all edges rounded; genus 1. Lengths
/// in millimetres. The eye is around the z axis, the narrow end at x = 60, the plate lies
/// on both sides of z = 0.
namespace truth
{

inline constexpr double kWideRadius = 24.0;
inline constexpr double kNarrowRadius = 12.0;
inline constexpr double kLength = 60.0; ///< between the centres of the two ends
inline constexpr double kEyeRadius = 11.0;
inline constexpr double kThickness = 16.0;
inline constexpr double kRounding = 4.0; ///< radius of all edges

/// Signed distance to the solid's surface, negative inside; exact to rounding for points outside
/// and for points less than the rounding below the surface.
inline double distance(const scan::Vec3& p)
{
  // the core, smaller by the rounding all around, then everything within the rounding of it
  const double outline = outlineDistance(
    p.x, std::abs(p.y), kLength, kWideRadius - kRounding, kNarrowRadius - kRounding);
  const double eye = kEyeRadius + kRounding - std::sqrt(p.x * p.x + p.y * p.y);
  const double flat = std::max(outline, eye);
  const double height = std::abs(p.z) - (0.5 * kThickness - kRounding);
  const double outsideFlat = std::max(flat, 0.0);
  const double outsideHeight = std::max(height, 0.0);
  return std::min(std::max(flat, height), 0.0) +
    std::sqrt(outsideFlat * outsideFlat + outsideHeight * outsideHeight) - kRounding;
}

} // namespace truth
