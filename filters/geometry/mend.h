// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/defects.h"
#include "filters/geometry/intersection_repair.h"
#include "filters/geometry/surface_edit.h"

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace scan
{

struct MendOptions
{
  DefectOptions defects;  ///< the kinds to repair, and what counts as one
  std::optional<Vec3> at; ///< repairs only the defect nearest to there
  /// No point that stays moves farther, in model units; pieces stay, too.
  double maxDeviation = std::numeric_limits<double>::infinity();
  int rounds = 4; ///< of repairs and tests, at most; 1 or more
};

/// What was done. For triangles: those of the input = those of the result + removed - added.
struct MendTally
{
  std::size_t degenerateRemoved = 0; ///< triangles without area, of which nothing is left
  std::size_t cutsAdded = 0;         ///< more triangles by cuts at corners of such
  std::size_t duplicatesRemoved = 0;
  std::size_t componentsRemoved = 0; ///< pieces
  std::size_t componentTriangles = 0;
  std::size_t holesFilled = 0;
  std::size_t holeTriangles = 0; ///< added
  std::size_t turned = 0;        ///< triangles
  std::size_t edgesSplit = 0;    ///< non-manifold ones, and those that cannot agree
  std::size_t pointsSplit = 0;
  std::size_t seamsClosed = 0; ///< edges
  std::size_t spikesMoved = 0;
  IntersectionRepair intersections; ///< its triangles are removed and added, too
  int rounds = 0;
  std::size_t pointsMoved = 0; ///< of those that stay
  double largestMove = 0.0;    ///< model units

  std::size_t removed() const
  {
    return this->degenerateRemoved + this->duplicatesRemoved + this->componentTriangles +
      this->intersections.removed;
  }
  std::size_t added() const
  {
    return this->cutsAdded + this->holeTriangles + this->intersections.added;
  }
};

struct MendResult
{
  SurfaceEdit edit;
  DefectList found; ///< triangles of the input
  DefectList left;  ///< triangles of the result
  MendTally tally;
};

/// Repairs what is wrong with a surface: what is neither found nor in the way stays as it is, bit
/// by bit. In this order, and again until nothing is left or nothing helps:
/// 1. seams are closed: points in one place become one;
/// 2. triangles that repeat others and those without area go, neighbours are turned until they
///    agree, closed pieces face outwards, sheets that touch are split (makeConsistent());
/// 3. spikes move to the middle of their neighbours;
/// 4. self-intersections (repairIntersections());
/// 5. small components go;
/// 6. small holes are filled, flat, where that intersects nothing.
/// With all kinds and no limit the result is an oriented manifold without self-intersections, or
/// `left` says what is left and where. Nothing is removed that the tally does not count.
///
/// Throws Error badInput for a triangle that names a missing point and coordinates that are not
/// finite; Cancelled. Reports "find defects" and "mend".
/// @param inRegion per triangle 0 or 1: only defects with a triangle of it
MendResult mend(const TriMesh& mesh, std::span<const std::uint8_t> inRegion,
  const MendOptions& options, Execution& execution);

} // namespace scan
