// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/basins.h"

#include <cstdint>
#include <vector>

namespace scan
{

// The automatic wrap labels every tetrahedron inside or outside; the surface is the cut, the
// triangles between the two. A good cut passes through many points and is a manifold of simple
// topology: maximise
//
//   F = V + (V - T/2) - mu * sum over cut triangles of their excess size
//
// with V the points on the cut and T its triangles (for a closed surface V - T/2 is its Euler
// characteristic). A bubble, a handle, a doubled layer cost (V - T/2), a missed point costs 1, mu
// discourages webs.

/// What refineBasins() flips in the end. Beyond the rim of an open sheet basins of both sides meet
/// through the widest doors: there every basin and every room of the outside is tried alone as
/// well. On closed surfaces that would only add crumbs; their outside stays outside.
enum class FinestGroups
{
  widestDoors,
  singleBasins
};

/// Flips groups of basins while F grows, coarse to fine: at level kappa = 3, 2, 1.5, ... 1 basins
/// with the same label are joined through triangles of radius r with min(size, size) / r <= kappa,
/// and each group is tried, largest first. All levels are swept for mu = 0.02, then 0.1.
/// @param walls hull walls have the number of basins + that of the room of the outside as `b`
/// @param inside per basin and room of the outside, 0 or 1: the start
/// @return the refined labels
/// Groups are tried again only where their surroundings changed. Reports phase "refine".
std::vector<std::uint8_t> refineBasins(const FlowComplex& flow, const Basins& basins,
  const std::vector<Wall>& walls, const std::vector<float>& spacing, FinestGroups finest,
  std::vector<std::uint8_t> inside, Execution& execution);

} // namespace scan
