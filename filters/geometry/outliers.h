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
  std::size_t inClumps = 0;          ///< in clumps of few points far from everything
  double largestRatio = 0.0;         ///< of the points that stay
};

/// Finds stray points without being told a distance. Per point the mean distance to its neighbours
/// is compared with the median of theirs, so that a density that changes is no reason (as in the
/// local outlier factor, Breunig et al. 2000). What was found no longer counts as a neighbour and
/// the comparison is repeated until nothing more is found: so a diffuse cloud of stray points,
/// which are neighbours of each other, is peeled. Clumps, too small to be a part of the scan, are
/// found by the gap around them.
///
/// Equal points are judged as one. Up to `neighbours` distinct points none is stray. Points outside
/// the region count as neighbours and are never stray. About 3 s and 150 bytes a point for a
/// million. Reports the phases "neighbours" and "outliers".
/// @param inRegion per point 0 or 1
/// @throws Error{badInput} for points that are not finite
OutlierResult findOutliers(std::span<const Vec3> points, std::span<const std::uint8_t> inRegion,
  const OutlierOptions& options, Execution& execution);

} // namespace scan
