// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/flow_complex.h"
#include "filters/geometry/outside_rooms.h"

#include <cstdint>
#include <vector>

namespace scan
{

/// Labelled tetrahedra and the triangles between them, see cutTriangles().
struct FineTuned
{
  std::vector<std::uint8_t> inside;
  std::vector<Facet> cut;
};

/// Flips single tetrahedra at the cut, then pairs of neighbours at points that it misses and at
/// edges with more than two cut triangles, while the objective F of basin_refinement.h grows, taken
/// with mu = 0.2 and less half a point for every non-manifold edge, one for every rim edge.
/// @param inside per tetrahedron, 0 or 1
/// Only tetrahedra whose surroundings changed are asked again. Reports phase "fine-tune".
FineTuned fineTune(const FlowComplex& flow, const std::vector<float>& spacing,
  const OutsideRooms& outside, std::vector<std::uint8_t> inside, Execution& execution);

} // namespace scan
