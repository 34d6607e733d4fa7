// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/edge_intervals.h"

#include <bit>

namespace scan
{

EdgeOfTriangle sharedEdge(const FlowComplex& flow, Index tet)
{
  const unsigned attached = flow.attachedFacets(tet);
  const auto first = static_cast<unsigned>(std::countr_zero(attached));
  const auto second = static_cast<unsigned>(std::countr_zero(attached & (attached - 1)));
  return { 4 * tet + first, flow.delaunay().tetrahedra[tet][second] };
}

EdgeInterval intervalOfEdge(const FlowComplex& flow, EdgeOfTriangle edge)
{
  const DelaunayComplex& complex = flow.delaunay();
  EdgeInterval interval;
  const auto isOwn = [&](Facet at, Index apex)
  { return flow.isFree(at) && flow.obtuseVertex(at) == apex; };
  if (isOwn(edge.triangle, edge.apex))
  {
    interval.triangle = complex.canonical(edge.triangle);
    return interval;
  }
  complex.walkWholeEdge(edge.triangle, edge.apex,
    [&](Facet entering, Facet leaving, Facet)
    {
      if (flow.isAttached(leaving))
      {
        interval.tet = flow.isAttached(entering) ? entering / 4 : kNone;
      }
      else if (isOwn(leaving, complex.tetrahedra[entering / 4][entering % 4]))
      {
        interval.triangle = complex.canonical(leaving);
      }
      return interval.tet == kNone && interval.triangle == kNone;
    });
  return interval;
}

int keptTrianglesAtEdge(const WrapComplex& complex, EdgeOfTriangle edge, int most)
{
  int count = 0;
  forEachTriangleAtEdge(complex.flow().delaunay(), edge,
    [&](Facet at, Index) { return (count += complex.keepsTriangle(at) ? 1 : 0) < most; });
  return count;
}

} // namespace scan
