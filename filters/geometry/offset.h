// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/mesh.h"
#include "filters/geometry/surface_edit.h"
#include "filters/geometry/surface_folds.h"

#include <cstdint>
#include <limits>
#include <span>

namespace scan
{

struct OffsetOptions
{
  double distance = 0.0; ///< model units: to where the triangles face; negative: the other way
  /// Model units: no point moves farther than this.
  double maxDeviation = std::numeric_limits<double>::infinity();
};

struct OffsetResult
{
  SurfaceEdit edit;
  SurfaceFolds folds;
  Index moved = 0;    ///< points
  Index heldBack = 0; ///< points that maxDeviation kept from going all the way
};

/// Moves the points of the region along offsetVectors(), so that the planes of their triangles
/// move by the distance; the triangles stay who they are, and those between points of the region
/// and others stretch. Points outside the region keep their place, bit by bit.
///
/// Closed surfaces grow with a positive distance and shrink with a negative one, also where some of
/// their triangles face the wrong way: sides are those that makeConsistent() finds. An open surface
/// moves to the side that most of its triangles face.
///
/// Exact on planes, at the edges between them and at most corners; see kLongestOffset for sharp
/// ones. Where the distance exceeds what the curvature or the next sheet leaves room for, the
/// surface folds onto itself: `folds` says where, and nothing is done about it.
///
/// Linear time besides findFolds(). Reports the phases "offset" and "folds".
/// Throws Error badInput for a missing point or coordinates that are not finite; Cancelled.
/// @param inRegion per point 0 or 1
OffsetResult offset(const TriMesh& mesh, std::span<const std::uint8_t> inRegion,
  const OffsetOptions& options, Execution& execution);

} // namespace scan
