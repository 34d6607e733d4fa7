// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/block_marks.h"
#include "filters/geometry/wrap_model.h"

#include <vector>

namespace scan
{

/// The blocks that a shot meets, in this order, each once: those of all kept tetrahedra and sheets
/// touched by the ray from a marked triangle of the surface, until it leaves the model for the
/// first time. Touching a vertex or edge is enough, so that a shot along the edges of a grid meets
/// what is around them. Exact for the line through the point with the direction rounded to doubles;
/// a point beside the triangle stands for the nearest one on it. Push these blocks to open a
/// passage. The cost is that of the tetrahedra touched.
/// @throws Error badInput for a direction that is zero, not finite or along the triangle's plane,
/// and for a triangle that is not on the surface.
std::vector<BlockName> blocksInSight(const WrapModel& model, Facet triangle, const Vec3& point,
  const Vec3& direction, Execution& execution);

} // namespace scan
