// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/mend_surface.h"

#include <cstddef>

namespace scan
{

/// What repairing self-intersections took.
struct IntersectionRepair
{
  std::size_t pulled = 0;  ///< points drawn back from others in the same place
  std::size_t relaxed = 0; ///< points smoothed
  std::size_t unions = 0;  ///< closed pieces joined to another
  std::size_t removed = 0; ///< triangles, for those added
  std::size_t added = 0;

  IntersectionRepair& operator+=(const IntersectionRepair& other)
  {
    this->pulled += other.pulled;
    this->relaxed += other.relaxed;
    this->unions += other.unions;
    this->removed += other.removed;
    this->added += other.added;
    return *this;
  }

  bool any() const { return this->pulled + this->relaxed + this->unions + this->removed > 0; }
};

/// Repairs intersections in which an active triangle takes part, by the gentlest means that helps:
/// - Points in one place that are not the same, as splitting leaves them, draw back a little: into
///   the piece, at a boundary into the sheet. By 2 % of the edges there, then 8 and 30 %.
/// - Closed pieces that reach into each other become their union, by exact corefinement (shells
///   that face outwards and do not intersect themselves).
/// - The triangles that intersect and those around them are relaxed, with a fixed border; where
///   that does not help the rings grow, from one to four. Not where points would move by one
///   and a half edges in the mean.
/// - The triangles that intersect and up to six rings around them go, and the holes are filled
///   with the least folds, without new points. At most half a piece.
/// What did not help is undone. So is what would move a point farther than `maxDeviation` from
/// where the input has it; unions are made without that limit only. The surface stays a manifold
/// when it was one. Throws Cancelled.
IntersectionRepair repairIntersections(
  MendSurface& surface, double maxDeviation, Execution& execution);

} // namespace scan
