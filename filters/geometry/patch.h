// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/edge_set.h"
#include "filters/geometry/mesh.h"

#include <vector>

namespace scan
{

/// A piece of surface that is being made to fill a hole: a disk.
struct Patch
{
  TriMesh mesh;                ///< the points of the rim first, then those within
  std::vector<Index> names;    ///< per point of the rim: its name in a set of taken edges
  std::vector<double> spacing; ///< per point: how long edges shall be there

  Index rim() const { return static_cast<Index>(this->names.size()); }
};

/// Flips inner edges until each is Delaunay on the surface (the angles opposite to it sum to a half
/// turn at most) or cannot be flipped: the other diagonal is there already, is taken, or a triangle
/// would turn over.
void flipEdges(Patch& patch, const EdgeSet& taken, Execution& execution);

/// Adds points in the middle of triangles until the edges are as long as the spacing, which new
/// points have from the corners around (Liepa 2003), and flips edges on the way.
/// @param growth by how much of an edge's length the spacing grows with every point inwards; 0:
///   not at all
void refinePatch(Patch& patch, double growth, const EdgeSet& taken, Execution& execution);

/// Moves the points within to the middle of their neighbours, some times: the points get more even,
/// the shape gets flatter.
void evenOut(Patch& patch);

} // namespace scan
