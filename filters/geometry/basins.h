// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/flow_complex.h"

#include <vector>

namespace scan
{

/// The tetrahedra grouped by where they flow to: the same sink, or out through the same hull
/// triangle. Basins are numbered along the tetrahedra.
struct Basins
{
  std::vector<Index> ofTet; ///< basin of each tetrahedron
  std::vector<Index> sink;  ///< per basin: its sink, kNone when it leaves through the hull
  std::vector<double> size; ///< per basin: largest circumradius, at most half the box diagonal

  Index count() const { return static_cast<Index>(this->sink.size()); }
  bool leavesHull(Index basin) const { return this->sink[basin] == kNone; }
};

/// Linear time. Reports phase "basins".
Basins findBasins(const FlowComplex& flow, Execution& execution);

/// A triangle between two basins, or between a basin and the outside of the convex hull.
struct Wall
{
  Facet facet;
  Index a; ///< basin of the facet's own tetrahedron
  Index b; ///< basin beyond; the number of basins stands for the outside
};

/// All walls, in the order of their facets.
std::vector<Wall> findWalls(const FlowComplex& flow, const Basins& basins, Execution& execution);

} // namespace scan
