// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/mend_surface.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace scan
{

/// Triangles that were exchanged for others.
struct Exchange
{
  std::size_t removed = 0;
  std::size_t added = 0;
  std::size_t places = 0; ///< patches or holes
};

/// Takes out patches of the surface, the parts of the region that hang together by edges, and spans
/// their rims with triangles between the points there. A patch stays where it is more than half of
/// its piece, or too large, or all rim; where its rim cannot be spanned without edges that are
/// there already; or where the new surface would be farther than `maxDeviation` from the old one.
/// @param inRegion per triangle 0 or 1
Exchange refillPatches(MendSurface& surface, const std::vector<std::uint8_t>& inRegion,
  double maxDeviation, Execution& execution);

/// Fills holes with a rim not longer than `longest`, as the rim suggests, without new points; not
/// the rims of sheets (isOuterRim()), and none with new triangles that would intersect others or
/// be farther than `maxDeviation` from the rim.
Exchange fillSmallHoles(
  MendSurface& surface, double longest, double maxDeviation, Execution& execution);

} // namespace scan
