// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/edge_set.h"
#include "filters/geometry/mesh.h"

#include <optional>
#include <span>
#include <vector>

namespace scan
{

/// A closed polygon in space that shall be spanned by triangles.
struct SpaceLoop
{
  std::vector<Vec3> corners;
  /// Per edge, from a corner to the next: the unit normal of the triangle beyond it; (0, 0, 0)
  /// where there is none.
  std::vector<Vec3> normals;
  /// Per corner: its name in the set of edges that must not be used as diagonals.
  std::vector<Index> names;
};

enum class LoopAim
{
  fold, ///< the sharpest fold, rim included, is least, then the area
  area  ///< the area is least
};

/// The triangles between the corners, which run as the polygon does. The best by dynamic
/// programming (Barequet, Sharir 1995; Liepa 2003), in cubic time, for up to 300 corners; a longer
/// polygon is cut first along short diagonals into such. None when there is no triangulation
/// without triangles of no area and without the taken diagonals. Throws Cancelled.
std::optional<std::vector<Triangle>> triangulateLoop(
  const SpaceLoop& loop, LoopAim aim, const EdgeSet& taken, Execution& execution);

} // namespace scan
