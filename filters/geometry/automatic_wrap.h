// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/basins.h"

#include <cstdint>
#include <vector>

namespace scan
{

/// What becomes of the openings of a scan.
enum class Opening
{
  automatic, ///< of the closed and the open result the better one
  keep,      ///< true openings stay open
  cap        ///< always closed
};

struct AutomaticWrapOptions
{
  bool fineTune = true; ///< flip single tetrahedra at the end; else whole basins only
  Opening opening = Opening::automatic;
};

/// A labelling of the tetrahedra and the surface between the labels.
struct AutomaticWrap
{
  std::vector<std::uint8_t> inside; ///< per tetrahedron, 0 or 1
  std::vector<Facet> surface;       ///< in increasing order; each seen from its inside, so that
                                    ///< facetVertices() face outward
  bool isOpen = false;              ///< from the signed start: the surface may have boundary
  Index openingTriangles = 0;       ///< cut triangles that span openings and are not shown
};

/// The phases that wrapAutomatically() reports, for Execution::plan.
std::vector<Phase> automaticWrapPhases(const AutomaticWrapOptions& options);

/// Finds the surface of a scan by one objective over its basins, refined coarse to fine, then
/// tetrahedron by tetrahedron. Persistent rooms start a closed surface. Where that leaves out
/// points, spans webs or has many handles, the two sides of a sheet (signed_rooms.h) start an open
/// one, taken if it costs less than 0.65 of
///
///   points missed + components + 2 handles + B / 4 + N / 2 + 0.2 * excess size
///
/// of what is shown, with B rim edges, N non-manifold edges, and handles with every rim capped.
/// Deterministic on any number of threads.
AutomaticWrap wrapAutomatically(const FlowComplex& flow, const Basins& basins,
  const AutomaticWrapOptions& options, Execution& execution);

} // namespace scan
