// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/mesh.h"
#include "filters/geometry/surface_edit.h"

#include <cstdint>
#include <limits>
#include <span>

namespace scan
{

struct BridgeOptions
{
  Vec3 from;       ///< near the rim where the bridge begins
  Vec3 to;         ///< near the rim where it ends, the same one or another
  Index width = 1; ///< edges of each rim that it joins, 1 or more
  /// Model units: no point of the bridge is farther from the surface, or it is refused.
  double maxDeviation = std::numeric_limits<double>::infinity();
};

struct BridgeResult
{
  SurfaceEdit edit;
  double length = 0.0;   ///< between the middles of its two ends
  bool joinsTwo = false; ///< two rims to one; otherwise it parts a hole in two
  Index pointsAdded = 0;
  Index trianglesAdded = 0;
};

/// Joins two rims, or two places of one, by a straight strip of triangles that faces as the surface
/// at its ends. It is cut across where it is long, so that its edges are about as long as those of
/// the rims. Points and triangles of the input stay as they are, in their order; new ones follow.
/// New points have the data of the two ends by their distances. A manifold stays one. Linear time.
/// Reports the phase "bridge".
/// @param inRegion per point 0 or 1: both ends are looked for among edges inside
/// Throws Error badInput for a missing point or coordinates that are not finite; badParameter when
/// there is no rim, one of them is too short for the width, the ends meet, they face opposite ways
/// so that the strip would be twisted, or it would cut the surface or be farther than the limit;
/// Cancelled.
BridgeResult bridge(const TriMesh& mesh, std::span<const std::uint8_t> inRegion,
  const BridgeOptions& options, Execution& execution);

} // namespace scan
