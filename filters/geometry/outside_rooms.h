// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/flow_complex.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace scan
{

/// The outside of the convex hull as rooms, one behind each piece of the hull that may be surface.
/// A closed scan has one outside. Around an open sheet both sides reach the outside: the hull's
/// triangles that span openings have no room, so that a surface may end there, and what hangs
/// together of the others has a room, and so a side, of its own.
struct OutsideRooms
{
  std::vector<Facet> facets;      ///< of the hull that have a room, in increasing order
  std::vector<Index> room;        ///< of each facet
  std::vector<std::uint8_t> side; ///< of each room, 0 or 1

  Index count() const { return static_cast<Index>(this->side.size()); }

  /// Room beyond a facet of the hull, kNone where there is none.
  Index beyond(Facet facet) const
  {
    const auto found = std::lower_bound(this->facets.begin(), this->facets.end(), facet);
    return found == this->facets.end() || *found != facet
      ? kNone
      : this->room[static_cast<std::size_t>(found - this->facets.begin())];
  }
};

/// One room for the whole hull, on side 0.
OutsideRooms oneOutside(const DelaunayComplex& complex, Execution& execution);

/// A room for each edge-connected piece of the hull without its openings (see withoutOpenings()),
/// all on side 0.
OutsideRooms denseOutside(
  const DelaunayComplex& complex, const std::vector<float>& spacing, Execution& execution);

/// The triangles between side 1 and side 0, in increasing order: of the two names that of side 1,
/// on the hull the only one.
/// @param inside per tetrahedron its side
std::vector<Facet> cutTriangles(const DelaunayComplex& complex, const OutsideRooms& outside,
  const std::vector<std::uint8_t>& inside, Execution& execution);

/// A cut triangle, counter-clockwise seen from outside. One on the convex hull may have its inside
/// beyond the hull: it faces into its tetrahedron.
inline Triangle outwardVertices(
  const DelaunayComplex& complex, const std::vector<std::uint8_t>& inside, Facet facet)
{
  const Triangle v = complex.facetVertices(facet);
  return inside[facet / 4] ? v : Triangle{ v[0], v[2], v[1] };
}

} // namespace scan
