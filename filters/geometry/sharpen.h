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

struct SharpenOptions
{
  /// Degrees, more than 0, less than 90: triangles that turn by more at their common edge are not
  /// smooth there. A chamfer of a right angle turns by 45 degrees at either side.
  double angle = 20.0;
  /// Model units: no point of the surface moves farther than this.
  double maxDeviation = std::numeric_limits<double>::infinity();
};

struct SharpenResult
{
  SurfaceEdit edit;
  Index edges = 0;    ///< of chamfers, cut at a new point on the sharp edge
  Index corners = 0;  ///< triangles where chamfers meet, with a new point at the sharp corner
  Index heldBack = 0; ///< new points that maxDeviation kept from going all the way
  Index leftOut = 0;  ///< edges of chamfers that stay: the planes beside them meet too far away or
                      ///< not, or the result would fold or cross itself
};

/// Makes edges sharp that sampling has cut off: a scan has no points right on them, so that its
/// surface has a strip of triangles there, a chamfer. Edges that lead across a chamfer get a point
/// where the planes of the smooth surface at their two ends meet, as near to their middle as
/// possible; triangles where three chamfers meet get one where the three planes do. All points
/// stay where they are. (Edge-Sharpener: Attene, Falcidieno, Rossignac, Spagnuolo 2003; the
/// checks are ours.)
///
/// Finds chamfers of one row of triangles only: of rounded edges wider than that nothing is known.
/// No new point is farther from the middle of what it cuts than the chamfer is wide there, which
/// leaves out edges sharper than 53 degrees; no part of a triangle faces against it, and no new
/// triangle crosses another. The surface stays as manifold, closed and oriented as it was; what is
/// not on a chamfer stays bit by bit.
///
/// Linear time but for the checks for crossings, a few times selfIntersections(). Reports the
/// phases "sharpen" and "check".
/// Throws Error badInput for a missing point or coordinates that are not finite; Cancelled.
/// @param inRegion per triangle 1 for those that may be cut
SharpenResult sharpen(const TriMesh& mesh, std::span<const std::uint8_t> inRegion,
  const SharpenOptions& options, Execution& execution);

} // namespace scan
