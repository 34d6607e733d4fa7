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

/// A subcomplex of a Delaunay complex: which tetrahedra and which free triangles are kept.
///
/// All vertices and critical edges are kept; a triangle that is attached to a tetrahedron is kept
/// with it; one that bounds a kept tetrahedron is kept.
class WrapComplex
{
public:
  explicit WrapComplex(const FlowComplex& flow)
    : Flow(flow)
    , State(flow.delaunay().tetCount(), 0)
  {
  }

  const FlowComplex& flow() const { return this->Flow; }

  bool keepsTet(Index tet) const { return this->State[tet] & kTet; }

  Index keptTetCount() const
  {
    return static_cast<Index>(std::count_if(this->State.begin(), this->State.end(),
      [](std::uint8_t state) { return (state & kTet) != 0; }));
  }

  /// Number of kept tetrahedra beside the triangle: 2 interior, 1 boundary, 0 sheet or gone.
  int keptSides(Facet facet) const
  {
    const Index beyond = this->Flow.delaunay().neighbour(facet / 4, static_cast<int>(facet % 4));
    return (this->keepsTet(facet / 4) ? 1 : 0) +
      (beyond != kNone && this->keepsTet(beyond) ? 1 : 0);
  }

  /// Kept without a kept tetrahedron on either side.
  bool isSheet(Facet facet) const
  {
    const Facet name = this->Flow.delaunay().canonical(facet);
    return this->State[name / 4] >> (name % 4) & 1U && this->keptSides(facet) == 0;
  }

  bool keepsTriangle(Facet facet) const
  {
    return this->keptSides(facet) > 0 || this->isSheet(facet);
  }

  void keepTet(Index tet) { this->State[tet] |= kTet; }
  void keepTriangle(Facet canonical)
  {
    this->State[canonical / 4] |= static_cast<std::uint8_t>(1U << (canonical % 4));
  }

private:
  static constexpr std::uint8_t kTet = 16;

  const FlowComplex& Flow;
  std::vector<std::uint8_t> State; ///< kTet; bit k: the canonical free triangle k is kept
};

/// The Wrap complex: what remains of the Delaunay complex after all collapses possible from the
/// outside, which is the union of the lower sets of all critical simplices. It is contractible.
/// Linear time; two bytes of working memory a tetrahedron. Reports phase "collapse".
/// Edelsbrunner, "Surface reconstruction by wrapping finite sets in space" (2003);
/// Bauer, Edelsbrunner (2017), section 6.
WrapComplex collapseFromOutside(const FlowComplex& flow, Execution& execution);

/// Kept edges without a kept triangle. Reports phase "edges".
std::vector<Segment> keptLines(const WrapComplex& wrap, Execution& execution);

} // namespace scan
