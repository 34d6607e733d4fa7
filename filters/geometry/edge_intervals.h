// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/flow_complex.h"
#include "filters/geometry/wrap_complex.h"

namespace scan
{

/// An edge as that of a triangle, opposite to its vertex `apex`.
struct EdgeOfTriangle
{
  Facet triangle;
  Index apex;
};

/// Of a tetrahedron with two attached facets: the edge they share.
EdgeOfTriangle sharedEdge(const FlowComplex& flow, Index tet);

/// The interval that an edge is the lower face of; both kNone when the edge is critical or the face
/// of an interval with a lower face of its own.
struct EdgeInterval
{
  Index tet = kNone;      ///< [edge, tetrahedron]
  Facet triangle = kNone; ///< [edge, triangle], its canonical name
};
EdgeInterval intervalOfEdge(const FlowComplex& flow, EdgeOfTriangle edge);

/// Calls visit(triangle, apex) for all triangles around an edge, each once, until it returns false.
template <class Visit>
void forEachTriangleAtEdge(const DelaunayComplex& complex, EdgeOfTriangle edge, Visit&& visit)
{
  const Facet start = edge.triangle;
  if (!visit(start, edge.apex))
  {
    return;
  }
  const Facet startMirror = complex.mirror[start / 4][start % 4];
  complex.walkWholeEdge(start, edge.apex,
    [&](Facet entering, Facet leaving, Facet)
    {
      return leaving == start || leaving == startMirror ||
        visit(leaving, complex.tetrahedra[entering / 4][entering % 4]);
    });
}

/// Number of kept triangles at an edge, counted up to `most`.
int keptTrianglesAtEdge(const WrapComplex& complex, EdgeOfTriangle edge, int most);

} // namespace scan
