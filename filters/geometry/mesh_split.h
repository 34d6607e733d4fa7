// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/half_edges.h"
#include "filters/geometry/mesh.h"

#include <vector>

namespace scan
{

/// A mesh cut apart where it was not a surface, and what that took.
struct SplitResult
{
  TriMesh mesh;
  std::vector<Index> pointOrigin; ///< per point of `mesh`: the input point that it copies
  std::vector<Index> mate;        ///< per half-edge of `mesh`: its reverse; kNone at a boundary
  Index edgesSplit = 0;           ///< input edges that had too many or misoriented triangles
  Index verticesSplit = 0;        ///< input points that have copies now
};

/// Makes any triangle set an oriented 2-manifold, with or without boundary, by duplicating points.
///
/// Every triangle stays, in the same order and orientation; every point stays in its place, used or
/// not, and copies follow after the last input point. Afterwards each directed edge belongs to at
/// most one triangle and the triangles at each used point form one disk or half-disk.
///
/// An edge with several triangles is parted into sheets that bound one solid wedge each, found by
/// turning around the edge with exact predicates; triangles left over there, and two triangles
/// that disagree about the orientation, become boundary. So a mesh whose directed edges are
/// balanced by their reverse (the border of any solid, however it touches itself) comes out closed.
/// Where both ends of an edge cannot tell its sheets apart, the sheets swap partners: the solid is
/// joined through that edge instead of cut. A triangle that names a point twice becomes an island.
///
/// Throws Error badInput for an index out of range. Linear time, 40 bytes of scratch a triangle.
SplitResult splitNonManifold(TriMesh mesh, Execution& execution);

/// The same for a mesh whose edges are known.
SplitResult splitNonManifold(TriMesh mesh, EdgePairs pairs, Execution& execution);

} // namespace scan
