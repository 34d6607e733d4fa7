// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/mesh.h"
#include "filters/geometry/triangle_tree.h"

#include <vector>

namespace scan
{

/// How far a surface is from another; distances from points of the first to the nearest of the
/// second, in model units.
struct SurfaceDeviation
{
  double mean = 0.0;    ///< over the area of the first
  double rms = 0.0;     ///< root of the mean square
  double largest = 0.0; ///< of the points that were looked at
  double atMost = 0.0;  ///< no point is farther: a bound that is proved, up to rounding
  Vec3 where;           ///< the point of the first where the largest was found
};

/// Measures from every point of the triangles of `from` to the surface of `to`. `atMost` exceeds
/// `largest` by a hundredth of it, or a millionth of the box diagonal of both where that is more,
/// unless that would take unreasonable time. Zeros when `from` has no triangles.
/// Phase "deviation". Throws Error badInput when `to` has no triangles or `from` names a missing
/// point; Cancelled.
SurfaceDeviation deviationFrom(const TriMesh& from, const TriangleTree& to, Execution& execution);

/// The triangles of `from` that have, or may have, a point farther than `limit` from `to`, sorted:
/// none of them is a proof, up to rounding, that the whole surface is within the limit. Others than
/// those that have one are rare: their distance is next to the limit. Phase and errors as above.
std::vector<Index> trianglesBeyond(
  const TriMesh& from, const TriangleTree& to, double limit, Execution& execution);

} // namespace scan
