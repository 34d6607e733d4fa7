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

struct RemeshOptions
{
  double edgeLength = 0.0; ///< model units; 0: the mean of the region
  int iterations = 5;      ///< 1 or more
  /// Degrees: edges where the surface bends more stay edges, and turn no corner; 180: none.
  double keepFeatures = 180.0;
  /// Model units: no point of either surface is farther from the other. Edges are made shorter
  /// where many would be, down to a quarter; other places where one would be stay as they are.
  double maxDeviation = std::numeric_limits<double>::infinity();
};

struct RemeshResult
{
  SurfaceEdit edit;
  double edgeLength = 0.0; ///< that was aimed at in the end
  double goodEdges = 0.0;  ///< share of the new edges with 4/5 to 4/3 of it
  double leastAngle = 0.0; ///< of the new triangles, degrees
  Index made = 0;          ///< new triangles
  Index heldBack = 0;      ///< triangles of the region that stay as they are
};

/// Replaces triangles of the region by nearly equilateral ones: long edges are split, short ones
/// collapsed, edges flipped for even numbers of neighbours, points moved along the surface and put
/// on the input (Botsch, Kobbelt 2004; CGAL).
///
/// Triangles outside come first, in their order and with their points in place, bit for bit; so do
/// the points of edges between both. Boundary edges are split and joined along themselves, with
/// corners kept; where there is an outside, they and features are split only. No self-intersection
/// is made: where one would be, and near what is no manifold, intersects itself or has no area,
/// triangles stay as they are. A point that stays keeps its origin, a new one has the data of the
/// nearest place of the input, a new triangle those of the nearest triangle.
///
/// About a minute for a million triangles and five iterations. Cancel is looked for between
/// iterations. Reports the phases "remesh" and "check".
/// @param inRegion per triangle 0 or 1
/// Throws Error badInput for a missing point or coordinates that are not finite, badParameter for
/// an edge length that would make more than 50 million triangles; Cancelled.
RemeshResult remesh(const TriMesh& mesh, std::span<const std::uint8_t> inRegion,
  const RemeshOptions& options, Execution& execution);

} // namespace scan
