// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/delaunay_complex.h"

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace scan
{

/// The intervals of the radius function on a Delaunay complex: the discrete gradient that decides
/// what collapses into what. Two bytes a tetrahedron.
///
/// The radius of a simplex is that of its smallest empty circumsphere. Simplices with the same
/// sphere form an interval [L, U]; L = U means critical. Ties are broken exactly, as the complex
/// breaks them, so the intervals partition the complex and the relation is acyclic on any input.
/// A facet is *attached* to the tetrahedron on one side when the opposite vertex lies inside the
/// facet's smallest sphere. A tetrahedron with no attached facet is a *sink*; with one, f, it forms
/// [f, tetrahedron]; with two, sharing the edge e, [e, tetrahedron].
/// Bauer, Edelsbrunner, "The Morse theory of Cech and Delaunay complexes" (2017).
class FlowComplex
{
public:
  /// Classifies all tetrahedra and triangles; reports phase "classify".
  FlowComplex(const DelaunayComplex& complex, Execution& execution);

  const DelaunayComplex& delaunay() const { return this->Complex; }

  unsigned attachedFacets(Index tet) const { return this->Attached[tet]; } ///< bit k: facet k
  bool isAttached(Facet facet) const { return this->Attached[facet / 4] >> (facet % 4) & 1U; }
  bool isSink(Index tet) const { return this->Attached[tet] == 0; }
  bool hasTwoAttached(Index tet) const
  {
    return (this->Attached[tet] & (this->Attached[tet] - 1U)) != 0;
  }

  /// The facet is attached to neither of its sides: the triangle's interval is its own or an
  /// edge's.
  bool isFree(Facet facet) const
  {
    const Facet other = this->Complex.mirror[facet / 4][facet % 4];
    return !this->isAttached(facet) && (other == kNone || !this->isAttached(other));
  }

  /// The vertex at the facet's obtuse angle, kNone without one. When the facet is free, the
  /// opposite edge e forms the interval [e, triangle], or the triangle is critical.
  Index obtuseVertex(Facet facet) const
  {
    const unsigned corner = this->Obtuse[facet / 4] >> (2 * (facet % 4)) & 3U;
    return corner == 0 ? kNone : this->Complex.facetVertices(facet)[corner - 1];
  }

  bool isObtuse(Facet facet) const
  {
    return (this->Obtuse[facet / 4] >> (2 * (facet % 4)) & 3U) != 0;
  }

  /// The edges of a tetrahedron, bits 0 to 5 for 01, 02, 03, 12, 13, 23, that one of its other two
  /// vertices sees at an obtuse angle: they are not critical.
  unsigned edgesSeenObtuse(Index tet) const;

  bool isCriticalTriangle(Facet facet) const
  {
    return this->isFree(facet) && !this->isObtuse(facet);
  }

  /// The facet through which a tetrahedron that is no sink flows on: its attached facet, of two
  /// the one whose other side has the larger circumradius (outside counts as infinite).
  Facet exit(Index tet) const;

private:
  const DelaunayComplex& Complex;
  std::vector<std::uint8_t> Attached; ///< bit k: facet k is attached to this tetrahedron
  std::vector<std::uint8_t> Obtuse;   ///< two bits a facet: 1 + its obtuse corner, or 0
};

/// Squared circumradius of a tetrahedron; large but finite or infinite for flat ones.
double circumradiusSquared(const DelaunayComplex& complex, Index tet);

/// Circumradius of a triangle.
double circumradius(const DelaunayComplex& complex, Facet facet);

/// Squared circumradius of a triangle.
double circumradiusSquared(const DelaunayComplex& complex, const Triangle& triangle);

/// An edge that no interval pairs with a triangle or tetrahedron, and a triangle that has it, seen
/// from the first tetrahedron that has it.
struct CriticalEdge
{
  Segment vertices;
  Facet triangle;
  Index apex; ///< the vertex of the triangle that is not on the edge
};

/// Calls visit(edge) for the critical edges (the Gabriel edges) whose first tetrahedron this is:
/// for each edge of the complex once.
void forEachCriticalEdge(const FlowComplex& flow, Index tet,
  const std::function<bool(Facet)>& wanted, const std::function<void(const CriticalEdge&)>& visit);

/// All critical edges (the Gabriel edges), in the order of their triangles; only edges for which
/// that triangle is `wanted`. Reports phase "edges".
std::vector<CriticalEdge> criticalEdges(
  const FlowComplex& flow, Execution& execution,
  const std::function<bool(Facet)>& wanted = [](Facet) { return true; });

} // namespace scan
