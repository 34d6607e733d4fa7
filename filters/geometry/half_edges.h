// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/mesh.h"

#include <cstdint>
#include <vector>

namespace scan
{

/// Half-edge 3 t + k runs from corner k to corner k + 1 of triangle t.
inline Index nextHalf(Index half)
{
  return half % 3 == 2 ? half - 2 : half + 1;
}
inline Index previousHalf(Index half)
{
  return half % 3 == 0 ? half + 2 : half - 1;
}
inline Index originOf(const TriMesh& mesh, Index half)
{
  return mesh.triangles[half / 3][half % 3];
}

/// A triangle that names a point twice; it takes part in no edge.
inline bool isCollapsed(const Triangle& triangle)
{
  return triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0];
}

/// Tells which way triangles with the same points face: the same way when it is the same for both.
inline bool isOddPermutation(const Triangle& triangle)
{
  const auto& [a, b, c] = triangle;
  return ((a > b) != (b > c)) != (a > c);
}

/// Throws Error badInput when a triangle names a missing point, and limit beyond 1.4 thousand
/// million triangles.
void requireCorners(const TriMesh& mesh);

/// Who meets whom at the edges of a mesh, whatever the orientation of the triangles.
struct EdgePairs
{
  /// Per half-edge: the half-edge of the other triangle where an edge has exactly two triangles,
  /// kNone elsewhere. The two are misoriented when they have the same origin.
  std::vector<Index> mate;
  /// Half-edges of edges with three triangles or more, edge by edge, ascending within an edge.
  std::vector<Index> crowded;
  /// Where each such edge begins in `crowded`, and its end.
  std::vector<Index> crowdedBegin = { 0 };
  /// The smaller half-edge of each pair of misoriented ones, sorted.
  std::vector<Index> misoriented;
  Index edges = 0;         ///< distinct edges
  Index boundaryEdges = 0; ///< edges with one triangle
};

/// Per half-edge 1 for those of edges that are no part of an oriented surface: with three triangles
/// or more, or with two that are misoriented.
std::vector<std::uint8_t> oddHalves(const EdgePairs& pairs);

/// Finds the edges of a mesh in linear time; needs 12 bytes of result and 24 of scratch space a
/// triangle. Throws as requireCorners().
EdgePairs pairEdges(const TriMesh& mesh, Execution& execution);
EdgePairs pairEdges(const TriMesh& mesh); ///< on one thread

} // namespace scan
