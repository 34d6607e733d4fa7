// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/mesh.h"

#include <cstdint>
#include <span>
#include <vector>

namespace scan
{

struct ThinOptions
{
  enum class By
  {
    random,   ///< a sample of `keep` percent, every sample equally likely
    spacing,  ///< no two points nearer than `spacing`, and none dropped that is farther
    grid,     ///< per cube of side `spacing` the point nearest to the mean of those in it
    curvature ///< a sample of `keep` percent, denser where the surface bends
  };
  By by = By::spacing;
  double keep = 25.0;   ///< percent of the points of the region, 0 to 100, rounded to a whole point
  double spacing = 0.0; ///< model units; 0 drops repeated points only
  std::uint64_t seed = 1; ///< of random and curvature
};

/// Chooses points to keep: per point 1 or 0. Points outside the region are kept and do not count.
///
/// - random: selection sampling (Knuth, TAOCP 2, 3.4.2 S): exactly round(keep n / 100) points.
/// - spacing: greedily along a Hilbert curve; the result does not depend on the order of the
/// points,
///   except that of equal points the first is kept.
/// - grid: the cubes start at the low corner of the region's bounding box; the first of equals.
/// - curvature: systematic sampling along a Hilbert curve (Madow 1949) with exactly round(keep n /
///   100) points. The chance of a point grows with the bending of the surface around it, the root
///   of Pauly's surface variation among 16 neighbours: edges are kept, flat parts sparse but even.
///
/// Deterministic on any number of threads. Nearly linear time: about 2 s for a million points,
/// random 0.02 s. Reports the phases "neighbours" and "thin".
/// @param inRegion per point 0 or 1
/// @throws Error{badInput} for points that are not finite (but random)
std::vector<std::uint8_t> thin(std::span<const Vec3> points, std::span<const std::uint8_t> inRegion,
  const ThinOptions& options, Execution& execution);

} // namespace scan
