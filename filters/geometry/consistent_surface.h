// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/mesh.h"

#include <vector>

namespace scan
{

/// An oriented 2-manifold, with or without boundary, and what it took to make it.
struct ConsistentSurface
{
  TriMesh mesh;
  std::vector<Index> pointOrigin = {};    ///< per point: the input point that it is, or copies
  std::vector<Index> triangleOrigin = {}; ///< per triangle: the input triangle it is a part of

  Index removed = 0;       ///< input triangles without area, of which nothing is left
  Index cuts = 0;          ///< how often a triangle was cut, where such a one lay on its edge
  Index turned = 0;        ///< triangles turned over
  Index edgesSplit = 0;    ///< edges that had too many triangles, or two that cannot agree
  Index verticesSplit = 0; ///< points that have copies now

  bool isChanged() const
  {
    return this->removed + this->cuts + this->turned + this->edgesSplit + this->verticesSplit > 0;
  }
};

/// Makes a surface that every program can work with: each triangle has area, each edge one triangle
/// or two that agree about the sides, each point one fan of triangles, and closed pieces face
/// outwards.
///
/// - Triangles without area go, and leave no gap (removeFlatTriangles()).
/// - Where neighbours disagree, the smaller part of their piece is turned (orientConsistently()).
/// - Edges and points where sheets touch are split (splitNonManifold()): the surface stays where it
///   is, points are repeated. A one-sided strip is cut open.
/// - A closed piece that faces inwards is turned, unless it is a void in a piece around it.
///
/// All points stay in their places, used or not; copies come last. A surface that is fine comes
/// back as it was. Linear time, as far as few pieces face inwards: about 0.2 s for a million
/// triangles on one thread.
///
/// Throws Error badInput for a triangle that names a missing point; Cancelled.
/// @param leastHeight of a triangle that has area, as in removeFlatTriangles()
ConsistentSurface makeConsistent(TriMesh mesh, double leastHeight, Execution& execution);

} // namespace scan
