// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/large_array.h"
#include "filters/geometry/mesh.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace scan
{

/// A facet of a tetrahedron: 4 * tetrahedron + index of the opposite vertex.
using Facet = Index;

/// Vertices of facet k of a tetrahedron, counter-clockwise seen from outside.
inline constexpr std::array<std::array<int, 3>, 4> kFacetVertices{ { { 1, 2, 3 }, { 0, 3, 2 },
  { 0, 1, 3 }, { 0, 2, 1 } } };

/// How a walk around an edge ended.
enum class EdgeWalk
{
  cameRound, ///< all triangles and tetrahedra around the edge were seen
  hull,      ///< the walk left the convex hull: what lies on the other side was not seen
  stopped    ///< the visitor had enough
};

/// The 3D Delaunay complex of a point set: flat arrays, 32 bytes a tetrahedron, never changed.
///
/// Cospherical points are triangulated as if each point p had weight -eps(p), the lexicographically
/// largest point having the largest eps, each next one infinitely smaller: the complex depends on
/// the points alone. Vertices are numbered along a Hilbert curve, the vertices of a tetrahedron
/// ascend or only the last two are exchanged, and tetrahedra are in lexicographic order: what is
/// near in space is near in memory. All tetrahedra are positively oriented:
/// (p1 - p0) x (p2 - p0) . (p3 - p0) > 0.
class DelaunayComplex
{
public:
  std::vector<Vec3> points;                    ///< distinct points, by vertex
  std::vector<Index> scanPoint;                ///< per vertex: its first index in the input
  LargeArray<std::array<Index, 4>> tetrahedra; ///< vertices of each tetrahedron
  LargeArray<std::array<Facet, 4>> mirror;     ///< per facet: the same facet seen from the other
                                               ///< side, kNone on the convex hull
  Index duplicates = 0;                        ///< input points merged into an earlier one

  Index tetCount() const { return static_cast<Index>(this->tetrahedra.size()); }

  /// The tetrahedron beyond facet k, kNone outside the convex hull.
  Index neighbour(Index tet, int k) const
  {
    const Facet other = this->mirror[tet][k];
    return other == kNone ? kNone : other / 4;
  }

  /// The facet's vertices, counter-clockwise seen from outside its tetrahedron.
  Triangle facetVertices(Facet facet) const
  {
    const auto& vertices = this->tetrahedra[facet / 4];
    const auto& local = kFacetVertices[facet % 4];
    return { vertices[local[0]], vertices[local[1]], vertices[local[2]] };
  }

  /// Of the two names of a triangle the smaller one.
  Facet canonical(Facet facet) const
  {
    const Facet other = this->mirror[facet / 4][facet % 4];
    return other < facet ? other : facet;
  }

  /// Local index of a vertex that the tetrahedron has.
  int localIndex(Index tet, Index vertex) const
  {
    const auto& v = this->tetrahedra[tet];
    return v[0] == vertex ? 0 : v[1] == vertex ? 1 : v[2] == vertex ? 2 : 3;
  }

  /// Walks around an edge: from the triangle `entering` into its tetrahedron, on through the next
  /// triangle at the edge, and so forth, until it is back at `entering` or at the hull.
  /// `behind` is the vertex of `entering` that is not on the edge. visit(entering, leaving, beyond)
  /// is called per tetrahedron with the facets it is entered and left through, both seen from it,
  /// and the mirror of the latter; it returns false to stop.
  template <class Visit>
  EdgeWalk walkAroundEdge(Facet entering, Index behind, Visit&& visit) const
  {
    const Facet until = this->mirror[entering / 4][entering % 4];
    while (true)
    {
      const Index tet = entering / 4;
      const Index ahead = this->tetrahedra[tet][entering % 4];
      const Facet leaving = 4 * tet + static_cast<Facet>(this->localIndex(tet, behind));
      const Facet beyond = this->mirror[tet][leaving % 4];
      if (!visit(entering, leaving, beyond))
      {
        return EdgeWalk::stopped;
      }
      if (leaving == until)
      {
        return EdgeWalk::cameRound;
      }
      if (beyond == kNone)
      {
        return EdgeWalk::hull;
      }
      entering = beyond;
      behind = ahead;
    }
  }

  /// The same from `entering` to both sides where the edge is on the hull: sees everything around
  /// the edge unless stopped. Returns false when stopped.
  template <class Visit>
  bool walkWholeEdge(Facet entering, Index behind, Visit&& visit) const
  {
    const EdgeWalk first = this->walkAroundEdge(entering, behind, visit);
    const Facet other = this->mirror[entering / 4][entering % 4];
    return first == EdgeWalk::cameRound ||
      (first == EdgeWalk::hull &&
        (other == kNone || this->walkAroundEdge(other, behind, visit) != EdgeWalk::stopped));
  }
};

/// Builds the complex, the same on any number of threads.
/// @throws Error badInput for fewer than four points, points in one plane, or coordinates that are
/// not finite or beyond 1e50; Cancelled within about a thousand insertions, input untouched.
/// Reports phase "triangulate". Scratch space 40 bytes a tetrahedron, 32 a point.
/// Follows delaunay_insertion.h and delaunay_worker.h, where the papers are.
DelaunayComplex buildDelaunayComplex(std::span<const Vec3> points, Execution& execution);

/// Whether all numbers in a complex that comes from a file fit together: vertices and facets exist,
/// and every facet and its mirror name each other and have the same vertices.
bool isWhole(const DelaunayComplex& complex, Execution& execution);

} // namespace scan
