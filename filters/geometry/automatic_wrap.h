// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/basins.h"

#include <cstdint>
#include <vector>

namespace scan
{

struct AutomaticWrapOptions
{
  bool fineTune = true; ///< flip single tetrahedra at the end; else whole basins only
};

/// A labelling of the tetrahedra and the surface between the labels.
struct AutomaticWrap
{
  std::vector<std::uint8_t> inside; ///< per tetrahedron, 0 or 1
  std::vector<Facet> surface;       ///< in increasing order; each seen from its inside, so that
                                    ///< facetVertices() face outward
};

/// The phases that wrapAutomatically() reports, for Execution::plan.
std::vector<Phase> automaticWrapPhases(const AutomaticWrapOptions& options);

/// Finds the surface of a scan by one objective over its basins: persistent rooms, refined coarse
/// to fine, then tetrahedron by tetrahedron. Deterministic on any number of threads.
AutomaticWrap wrapAutomatically(const FlowComplex& flow, const Basins& basins,
  const AutomaticWrapOptions& options, Execution& execution);

} // namespace scan
