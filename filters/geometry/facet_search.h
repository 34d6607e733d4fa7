// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/delaunay_complex.h"

#include <span>
#include <vector>

namespace scan
{

/// Of some triangles of a complex the one nearest to a point, the first of several; kNone when
/// there are none. Linear time, in parallel.
Facet nearestFacet(const DelaunayComplex& complex, std::span<const Facet> facets, const Vec3& point,
  Execution& execution);

/// The triangle as the facet of its tetrahedron on the side of a point; on the hull there may be
/// none, and the only name is returned.
Facet facetTowards(const DelaunayComplex& complex, Facet facet, const Vec3& point);

/// Those that come nearer to a point than a distance, in their order.
std::vector<Facet> facetsWithin(const DelaunayComplex& complex, std::span<const Facet> facets,
  const Vec3& point, double distance, Execution& execution);

} // namespace scan
