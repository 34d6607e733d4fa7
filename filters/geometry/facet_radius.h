// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/flow_complex.h"

namespace scan
{

/// Squared radius of the smallest empty sphere through a triangle: an attached facet has that of
/// its tetrahedron. Large but finite or infinite for flat ones.
inline double facetRadiusSquared(const FlowComplex& flow, Facet facet)
{
  const DelaunayComplex& complex = flow.delaunay();
  if (flow.isAttached(facet))
  {
    return circumradiusSquared(complex, facet / 4);
  }
  return flow.isFree(facet)
    ? circumradiusSquared(complex, complex.facetVertices(facet))
    : circumradiusSquared(complex, complex.neighbour(facet / 4, static_cast<int>(facet % 4)));
}

} // namespace scan
