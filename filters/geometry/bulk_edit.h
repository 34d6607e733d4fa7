// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/collapse_graph.h"
#include "filters/geometry/wrap_change.h"
#include "filters/geometry/wrap_complex.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace scan
{

/// Which critical simplices a state is to keep.
struct CriticalChoice
{
  std::vector<std::uint8_t> holdsBasin; ///< per basin: 1 to keep its sink, 0 where it has none

  /// Whether a critical triangle, by its place in the graph, is kept when nothing else keeps it;
  /// `was` tells whether it is kept now. Any thread may ask, before the state is edited.
  std::function<bool(Index i, bool was)> keepsTriangle;
};

/// Those that the state keeps now.
CriticalChoice criticalChoiceOf(const WrapComplex& kept, const Basins& basins);

struct BulkReport
{
  WrapChange change;
  Index criticalTriangles = 0; ///< that went

  BulkReport& operator+=(const BulkReport& other)
  {
    this->change += other.change;
    this->criticalTriangles += other.criticalTriangles;
    return *this;
  }
};

/// Turns a state that follows the flow into the one with other critical simplices: the same as all
/// collapses and additions one after the other, in any order. Each node of the graph is decided
/// once, holders first, in parallel; the state is written where something changes. One byte a node.
/// After Cancelled the state is of no use.
/// Edelsbrunner, "Surface reconstruction by wrapping finite sets in space" (2003), section 6.
BulkReport editInBulk(WrapComplex& kept, const CollapseGraph& graph, const CriticalChoice& choice,
  Execution& execution);

} // namespace scan
