// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/mesh.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace scan
{

/// Two triangles, the smaller number first.
using TrianglePair = std::array<Index, 2>;

/// The pairs of triangles that meet in more than the corners or the edge that they share, sorted.
/// Exact: signs are those of exact arithmetic on the coordinates. Triangles that fold back on their
/// neighbour over a shared edge count, so do overlaps in a plane and triangles with the same
/// corners. What touches counts, too, where it shares no corner there: corners are shared by
/// number, not by place. Collapsed and flat triangles are left out; mend lists them.
///
/// Throws Error badInput for a missing point or coordinates that are not finite; Cancelled.
std::vector<TrianglePair> selfIntersections(const TriMesh& mesh, Execution& execution);

/// Those of them that have one or two of the given triangles: what to check after a change. Few are
/// found in a fraction of the time for all.
std::vector<TrianglePair> selfIntersections(
  const TriMesh& mesh, std::span<const Index> ofTriangles, Execution& execution);

} // namespace scan
