// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/blocks.h"
#include "filters/geometry/bulk_edit.h"
#include "filters/geometry/edge_intervals.h"
#include "filters/geometry/wrap_change.h"
#include "filters/geometry/wrap_complex.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace scan
{

/// Removes and adds simplices of a subcomplex, keeps it closed and counts what changed. The cost is
/// that of the surroundings of what changes, whatever the size of the complex.
///
/// Edges are kept as faces of triangles only, except for the lines given at the start: an edge that
/// loses its last triangle goes with it.
class WrapEditor
{
public:
  /// @param lines edges that stay without a triangle, sorted by their vertices
  WrapEditor(WrapComplex& complex, std::span<const CriticalEdge> lines);

  /// Removes a kept tetrahedron; facets that nothing else is kept beside stay as sheets.
  void removeTet(Index tet);

  /// Removes a sheet, and its edges where no other triangle is left.
  void removeSheet(Facet facet);

  /// All collapses of intervals that became possible since the last call. What is left does not
  /// depend on their order.
  void collapse(Execution& execution);

  /// Removes the sinks of volume blocks that are kept, and everything that then collapses.
  void removeVolumes(std::span<const Index> volumes, const Blocks& blocks, Execution& execution);

  /// Keeps the chosen critical simplices and what they hold; for states that follow the flow.
  /// Returns the number of critical triangles that went.
  Index choose(const CollapseGraph& graph, const CriticalChoice& choice, Execution& execution);

  /// Adds a tetrahedron or triangle with its faces and everything that collapses only after it: the
  /// lower set of the radius function's relation. Only what `within` keeps, where that is given.
  void addLowerSet(Index tet, const WrapComplex* within, Execution& execution);
  void addLowerSetOfTriangle(Facet facet, const WrapComplex* within, Execution& execution);

  /// Adds a tetrahedron or triangle with its faces, unless it is kept, and nothing else.
  void addTet(Index tet);
  void addSheet(Facet facet);

  const WrapChange& change() const { return this->Change; }

  /// Triangles that became sheets by removals, some of which may have gone again.
  const std::vector<Facet>& baredSheets() const { return this->BaredSheets; }

private:
  void collapseTet(Index tet);
  void collapseTriangle(Facet facet);
  void reviewEdge(EdgeOfTriangle edge);
  void reviewInterval(EdgeOfTriangle edge, Index tet);
  void meetEdge(EdgeOfTriangle edge);
  void addLowerSets(std::vector<Index> tets, std::vector<Facet> triangles,
    const WrapComplex* within, Execution& execution);
  Segment verticesOf(EdgeOfTriangle edge) const;
  bool isLine(EdgeOfTriangle edge) const;

  WrapComplex& Kept;
  const FlowComplex& Flow;
  const DelaunayComplex& Complex;
  std::span<const CriticalEdge> Lines;
  WrapChange Change;
  std::vector<Index> Tets;      ///< that may collapse now
  std::vector<Facet> Triangles; ///< that may collapse now
  std::vector<Facet> BaredSheets;
};

} // namespace scan
