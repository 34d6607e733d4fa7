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

struct OutlierOptions
{
  Index neighbours = 16; ///< that tell whether a point is stray, 4 to 1000

  /// A point is stray when its neighbours are so many times as far as those of its neighbours are,
  /// usually; above 1. Where the scan itself is so uneven that many points are, it takes more.
  double factor = 3.0;
};

struct OutlierResult
{
  std::vector<std::uint8_t> isStray; ///< per point
  std::size_t single = 0;            ///< stray points by themselves
  std::size_t together = 0;          ///< stray points in clouds and clumps
};

/// Finds stray points without being told a distance:
///
/// - single points, whose neighbours are far compared with theirs: the mean distance is compared
///   with the median of those of the neighbours, so that a density that changes is no reason (as in
///   the local outlier factor, Breunig et al. 2000); points among the nearest of no other are told
///   from 0.6 times the factor on when they are off the plane of their neighbours;
/// - clouds: strays that are neighbours of each other. Places hang together when each is among the
///   nearest of the other, at a like spacing, and both on a surface or both not. What hangs
///   together and is no surface, or too small to tell, is stray when it is thin beside the surface
///   nearby;
/// - clumps of few points (up to 4 times `neighbours`, and a fiftieth of all) with a gap around
/// them
///   of eight times their spacing.
///
/// Equal points are judged as one. Up to `neighbours` distinct points none is stray. Points outside
/// the region count as neighbours and are never stray. About 3 s and 200 bytes a point for a
/// million. Reports the phases "neighbours" and "outliers".
/// @param inRegion per point 0 or 1
/// @throws Error{badInput} for points that are not finite
OutlierResult findOutliers(std::span<const Vec3> points, std::span<const std::uint8_t> inRegion,
  const OutlierOptions& options, Execution& execution);

} // namespace scan
