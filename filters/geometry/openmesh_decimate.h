// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/decimate.h"

namespace scan
{

/// Further conditions that decimateByOpenMesh() keeps.
struct OpenMeshConditions
{
  /// By how much the triangles that a new one stands for may turn from each other, degrees; 180: no
  /// condition.
  double maxNormalDeviation = 180.0;

  /// No edge becomes longer than that, in model units; infinity: no condition.
  double longestEdge = std::numeric_limits<double>::infinity();

  /// No triangle that is better becomes longer, as a multiple of its height; 0: no condition.
  double maxAspectRatio = 0.0;
};

/// Decimates with the decimater of OpenMesh: points go, others stay in their places, in the order
/// of a heap. Slower than decimate(), and surfaces may come to intersect themselves (the result
/// counts pairs of triangles); but it has conditions that decimate() has not. Boundary points go
/// along the boundary; creases only count by their quadrics. A limit for the deviation is proved.
///
/// Parts that are no manifold are split first and their points stay; pieces of the input keep to
/// themselves. Errors as decimate().
DecimateResult decimateByOpenMesh(const TriMesh& mesh, const DecimateOptions& options,
  const OpenMeshConditions& conditions, Execution& execution);

} // namespace scan
