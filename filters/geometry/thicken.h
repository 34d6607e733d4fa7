// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/consistent_surface.h"
#include "filters/geometry/mesh.h"
#include "filters/geometry/surface_edit.h"
#include "filters/geometry/surface_folds.h"

#include <cstdint>
#include <limits>
#include <span>

namespace scan
{

/// Where the solid lies; "out" is where the triangles face.
enum class ThickenSide
{
  both, ///< half of it on either side of the surface
  out,
  in
};

struct ThickenOptions
{
  double thickness = 0.0; ///< model units, more than 0
  ThickenSide side = ThickenSide::both;
  /// Model units: no point of the solid is farther than this from the point it comes from.
  double maxDeviation = std::numeric_limits<double>::infinity();
};

struct ThickenResult
{
  SurfaceEdit edit;
  SurfaceChanges changes; ///< that made all of the input a surface with two sides
  SurfaceFolds folds;     ///< of the solid; numbers are those of the triangles of `edit`
  Index strip = 0;        ///< triangles that join the rims of the two copies
  Index heldBack = 0;     ///< points that maxDeviation kept from going all the way
};

/// Turns a surface into a solid of uniform thickness: two copies of it, moved along
/// offsetVectors() to either side, the one on the back turned over, and along every boundary a
/// strip of two triangles an edge between them. A surface with boundary becomes a closed
/// 2-manifold that faces outwards, a closed one a shell with a void in it. What is no oriented
/// 2-manifold is made one first by makeConsistent(): points are repeated where sheets touch.
///
/// Near sharp edges and corners offsets are bounded, see kLongestOffset. Where the thickness
/// exceeds what the curvature or the next sheet leaves room for, the solid folds onto itself:
/// `folds` says where, and nothing is done about it.
///
/// With a region its triangles become a solid of their own. All other triangles stay as they are,
/// bit by bit, and hang together with the solid no more: their points are repeated.
///
/// Order of the points: those that stay (of other triangles, or of none), those of the copy that
/// faces as the surface does, those of the other. Of the triangles: those that stay, copies,
/// turned copies, strip. Both copies of a point have it for their origin.
///
/// Linear time besides findFolds(). Reports the phases "thicken" and "folds".
/// Throws Error badParameter for a thickness that is not more than 0; badInput for a missing point
/// or coordinates that are not finite; Cancelled.
/// @param inRegion per triangle 0 or 1
ThickenResult thicken(const TriMesh& mesh, std::span<const std::uint8_t> inRegion,
  const ThickenOptions& options, Execution& execution);

} // namespace scan
