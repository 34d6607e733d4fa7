// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/mesh.h"
#include "filters/geometry/surface_edit.h"

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace scan
{

/// How a patch continues the surface around a hole.
enum class FillShape
{
  flat,    ///< triangles between the points of the rim, no new points
  tangent, ///< new points as dense as those of the rim; tangent planes go on
  curved   ///< so does the curvature
};

/// What bounds an open piece of surface, and so is no hole.
enum class OuterRims
{
  automatic, ///< isOuterRim()
  keep,      ///< the longest loop of every piece
  fill       ///< none
};

/// A place on the rim where a part of a hole begins, and one where it ends.
struct RimPart
{
  Vec3 from;
  Vec3 to;
};

struct FillHolesOptions
{
  FillShape shape = FillShape::tangent;
  OuterRims outerRims = OuterRims::automatic;
  double maxPerimeter = 0.0; ///< model units: longer ones are left; 0: any
  Index maxEdges = 0;        ///< those with more are left; 0: any
  /// Only the hole whose rim is nearest to each of these, whatever it bounds; empty: all.
  std::vector<Vec3> at = {};
  /// Only the part of one hole between the two points of its rim that are nearest to these, on the
  /// shorter way, closed by a straight line; in place of `at` and `outerRims`.
  std::optional<RimPart> part = {};
  /// Model units: a patch stays this near to the flat one, or becomes flatter.
  double maxDeviation = std::numeric_limits<double>::infinity();
};

enum class HoleFate
{
  filled,
  outerRim,      ///< bounds an open piece
  tooLong,       ///< maxPerimeter
  tooManyEdges,  ///< maxEdges
  notAsked,      ///< `at` or `part` names others
  outsideRegion, ///< a point of its rim is outside
  notManifold,   ///< edges with too many or misoriented triangles touch it
  noRoom         ///< every patch would cut the surface or another patch, or repeat an edge
};

struct Hole
{
  Vec3 place;          ///< the middle of its rim
  double length = 0.0; ///< of its rim; of a part, with the line that closes it
  Index edges = 0;
  HoleFate fate = HoleFate::filled;
  FillShape shape = FillShape::flat; ///< of the patch, perhaps flatter than asked for
};

struct FillHolesResult
{
  SurfaceEdit edit;
  std::vector<Hole> holes; ///< all boundary loops
  Index pointsAdded = 0;
  Index trianglesAdded = 0;
};

/// Closes holes by patches that face as the surface around them.
///
/// Points and triangles of the input stay as they are, in their order; new ones follow, patch by
/// patch. A patch never meets the surface or another patch but at its rim: where the shape asked
/// for does, a flatter one is tried, then the flat one of least area; then the hole is left. No
/// edge gets a third triangle. So a manifold stays one, and points where two holes meet become
/// manifold when both are filled; where the input is no manifold it stays as it is. Data of new
/// points are those of the three nearest of the rim by inverse distance.
///
/// Large holes get coarser patches away from the rim: beyond about 20,000 new points the edges
/// grow inwards. A rim of 6000 edges takes about 2 s. Reports the phases "fill" and "check".
/// @param inRegion per point 0 or 1: only holes all of whose rim is inside
/// Throws Error badInput for a missing point or coordinates that are not finite, badParameter when
/// `at` or `part` is given and there is no boundary, or both places of `part` are the same point,
/// on different loops or neighbours; Cancelled.
FillHolesResult fillHoles(const TriMesh& mesh, std::span<const std::uint8_t> inRegion,
  const FillHolesOptions& options, Execution& execution);

} // namespace scan
