// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/delaunay_complex.h"

#include <vector>

namespace scan
{

/// Leaves out the triangles that span openings of the scan.
///
/// A triangle is sparse when its circumradius is above 4 h and its area above 2 h^2, with h the
/// largest local spacing at its vertices. Sparse triangles that hang together by edges span an
/// opening when they reach the rim of `facets` or have more than 40 h^2 of area; a smaller hole
/// stays closed. Where three triangles are left at an edge, one goes that no point needs. Then,
/// from the rims inwards, triangles above 3 h go, the largest first, as long as that only moves the
/// rim: no point is lost and the topology stays.
/// @param spacing see localSpacing()
/// @return the facets that stay, in the same order. n log n.
std::vector<Facet> withoutOpenings(const DelaunayComplex& complex,
  const std::vector<float>& spacing, const std::vector<Facet>& facets);

} // namespace scan
