// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/edge_intervals.h"

#include <bit>

namespace scan
{

/// The upper simplex of an interval: a tetrahedron, or a free triangle by its canonical facet.
struct Upper
{
  bool isTet;
  Index name;

  friend bool operator==(const Upper&, const Upper&) = default;
};

/// Calls visit(upper) for the tetrahedra and free triangles around the edge of the triangle `start`
/// opposite to `apex`, but for `own` and `start`, until it returns false. Returns false when
/// stopped.
template <class Visit>
bool forEachUpperAround(const FlowComplex& flow, Facet start, Index apex, Upper own, Visit&& visit)
{
  const DelaunayComplex& complex = flow.delaunay();
  const Facet startName = complex.canonical(start);
  return complex.walkWholeEdge(start, apex,
    [&](Facet entering, Facet leaving, Facet)
    {
      const Upper tet{ true, entering / 4 };
      if (tet != own && !visit(tet))
      {
        return false;
      }
      const Facet name = complex.canonical(leaving);
      return name == startName || !flow.isFree(name) || visit(Upper{ false, name });
    });
}

/// The holders of an interval [L, U] are the upper simplices of the other intervals that have a
/// coface of L. An interval that is not critical stays in a state that follows the flow exactly
/// when one of its holders does. Here those next to U, of a critical triangle all: the tetrahedra
/// beyond attached facets, or on the sides of a triangle. Calls visit(holder) until it returns
/// false, and returns false then.
template <class Visit>
bool forEachNearHolder(const FlowComplex& flow, Upper upper, Visit&& visit)
{
  const auto visitBeyond = [&](Facet facet)
  {
    const Index beyond = flow.delaunay().neighbour(facet / 4, static_cast<int>(facet % 4));
    return beyond == kNone || visit(Upper{ true, beyond });
  };
  if (!upper.isTet)
  {
    return visit(Upper{ true, upper.name / 4 }) && visitBeyond(upper.name);
  }
  for (unsigned rest = flow.attachedFacets(upper.name); rest != 0; rest &= rest - 1)
  {
    if (!visitBeyond(4 * upper.name + static_cast<Facet>(std::countr_zero(rest))))
    {
      return false;
    }
  }
  return true;
}

/// The same for all holders when L is an edge, none otherwise; some come more than once.
template <class Visit>
bool forEachHolderAround(const FlowComplex& flow, Upper upper, Visit&& visit)
{
  if (!upper.isTet)
  {
    const Index apex = flow.obtuseVertex(upper.name);
    return apex == kNone || forEachUpperAround(flow, upper.name, apex, upper, visit);
  }
  if (!flow.hasTwoAttached(upper.name))
  {
    return true;
  }
  const EdgeOfTriangle edge = sharedEdge(flow, upper.name);
  return forEachUpperAround(flow, edge.triangle, edge.apex, upper, visit);
}

} // namespace scan
