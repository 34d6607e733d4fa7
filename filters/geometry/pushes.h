// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/block_marks.h"
#include "filters/geometry/model_edit.h"
#include "filters/geometry/wrap_model.h"

#include <span>
#include <vector>

namespace scan
{

struct PushOptions
{
  bool deep = false;   ///< and every block that one can pass to from there, recursively
  double reach = 1.5;  ///< kappa >= 1: one passes from a block of size r through doors of r / kappa
  bool compare = true; ///< report the change of the surface; otherwise see compareSurfaces()
};

/// What a push or pull did.
struct PushReport : EditReport
{
  /// Removed or added: volume blocks in the order they were reached, and sheet blocks. A wall
  /// between blocks that were gone before is one of these.
  std::vector<BlockName> blocks;
  Index doors = 0; ///< walls removed, beside these, between blocks that are both gone
};

/// Removes the blocks that the triangles of the surface belong to now, and those given by name;
/// triangles that are not on the surface, blocks that are gone and sheets that a solid still needs
/// are left out. Removing a block removes its critical simplex, and everything that then
/// collapses. Afterwards doors are removed whose sides are both gone and one of which passes to the
/// other: walls between rooms of one hollow vanish, the scanned surface between two hollows stays.
/// Of a solid model the block's tetrahedra are removed and no sheets stay.
/// Time and memory follow what is removed, plus a copy of the state.
/// Edelsbrunner, "Surface reconstruction by wrapping finite sets in space" (2003), section 6.
PushReport push(WrapModel& model, std::span<const Facet> triangles,
  std::span<const BlockName> named, const PushOptions& options, Execution& execution);

/// Adds removed blocks back, as far as they were there at the start if they were: the inverse of
/// push. With `deep` also the removed blocks that one passes to. Volumes come first; a sheet that
/// comes with one is not reported.
PushReport pull(WrapModel& model, std::span<const BlockName> removed, const PushOptions& options,
  Execution& execution);

} // namespace scan
