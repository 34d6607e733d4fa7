// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/mesh.h"

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace scan
{

struct RelaxOptions
{
  enum class Boundary
  {
    keep, ///< points on a boundary stay
    relax ///< they move towards the mean of the two beside them on the boundary
  };

  int iterations = 50; ///< pairs of steps; 1 or more
  double lambda = 0.7; ///< weight of the first step of a pair; above 0, at most 1
  /// Of the second, which undoes the shrinking; below -lambda, at least -1.1. What alternates from
  /// point to point must not grow: (1 - 2 lambda) (1 - 2 mu) is at least -1.
  double mu = -0.705;
  Boundary boundary = Boundary::keep;
  double featureAngle = 0.0; ///< degrees, up to 180: edges that bend by more stay sharp; 0: none
  /// Model units: no point ends farther than this from where it was.
  double maxDeviation = std::numeric_limits<double>::infinity();
};

struct RelaxResult
{
  std::vector<Vec3> points;
  std::size_t moved = 0;
  std::size_t limited = 0;        ///< of these, held back by maxDeviation
  std::size_t featureEdges = 0;   ///< that stayed sharp
  std::size_t featureCorners = 0; ///< where feature lines end or meet
  double meanShift = 0.0;         ///< of the points of the region, model units
  double largestShift = 0.0;      ///< at most maxDeviation, exactly
  /// Enclosed, of a surface without boundary whose triangles face the same side; none of others.
  std::optional<double> volumeBefore;
  std::optional<double> volumeAfter;
};

/// Takes noise out of a surface by moving its points; triangles keep their corners. Every point
/// moves towards the mean of its neighbours by `lambda` and back by `mu`, all points at once, again
/// and again (Taubin 1995), on a surface that is curved without being dented by it: see
/// umbrellaSteps(). Keeps volume within 1 % over 50 iterations where the noise is smaller than the
/// shape.
///
/// Points outside the region stay bit for bit and count as neighbours: the surface goes on there
/// without a step. Stay, too: points without triangles, on crowded edges, of collapsed triangles,
/// and where fans of triangles touch; and closed pieces of fewer than twelve points, of which
/// nothing would be left.
///
/// With a feature angle sharp edges are found on a surface cleaned by guidedFilter(), which moves
/// points onto the edges. Then points along an edge relax along it, corners stay.
///
/// As corresponding points of triangles are never farther apart than their corners, the surface
/// stays within maxDeviation of where it was, both ways.
///
/// The same bytes on any number of threads. About 0.4 s for a million triangles and 50 iterations,
/// 0.1 s more with a largest deviation, 7 s more with features. Reports the phases "features", if
/// there are, and "relax".
/// @param inRegion per point 0 or 1
/// @throws Error{badInput} for points that are not finite and triangles that name missing points;
/// Error{badParameter} for weights out of their ranges
RelaxResult relax(const TriMesh& mesh, std::span<const std::uint8_t> inRegion,
  const RelaxOptions& options, Execution& execution);

} // namespace scan
