// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/flow_complex.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace scan
{

/// A closed subcomplex of a Delaunay complex: the tetrahedra that are kept, and the *sheets*, the
/// triangles that are kept with no kept tetrahedron on either side. Faces of these are kept too,
/// and so is every vertex. One byte a tetrahedron; two of them are equal exactly when the same
/// tetrahedra and triangles are kept.
class WrapComplex
{
public:
  explicit WrapComplex(const FlowComplex& flow)
    : Flow(&flow)
    , State(flow.delaunay().tetCount(), 0)
  {
  }

  /// The state that has these bytes.
  /// @throws Error badInput when they cannot be a state of the complex
  WrapComplex(const FlowComplex& flow, std::vector<std::uint8_t> bytes, bool followsFlow);

  /// What is kept, a byte a tetrahedron.
  std::span<const std::uint8_t> bytes() const { return this->State; }

  const FlowComplex& flow() const { return *this->Flow; }

  bool keepsTet(Index tet) const { return this->State[tet] & kTet; }

  /// Has the processor fetch what keepsTet() will read.
  void prefetch(Index tet) const { __builtin_prefetch(&this->State[tet]); }

  Index keptTetCount() const
  {
    return static_cast<Index>(std::count_if(this->State.begin(), this->State.end(),
      [](std::uint8_t state) { return (state & kTet) != 0; }));
  }

  /// Number of kept tetrahedra beside the triangle: 2 interior, 1 boundary, 0 sheet or gone.
  int keptSides(Facet facet) const
  {
    const Index beyond = this->Flow->delaunay().neighbour(facet / 4, static_cast<int>(facet % 4));
    return (this->keepsTet(facet / 4) ? 1 : 0) +
      (beyond != kNone && this->keepsTet(beyond) ? 1 : 0);
  }

  bool isSheet(Facet facet) const
  {
    const Facet name = this->Flow->delaunay().canonical(facet);
    return this->State[name / 4] >> (name % 4) & 1U;
  }

  /// The same for canonical facets.
  bool isSheetNamed(Facet name) const { return this->State[name / 4] >> (name % 4) & 1U; }

  /// The kept tetrahedron beside a boundary triangle.
  Index keptTetAt(Facet boundary) const
  {
    return this->keepsTet(boundary / 4)
      ? boundary / 4
      : this->Flow->delaunay().neighbour(boundary / 4, static_cast<int>(boundary % 4));
  }

  /// Bit k: facet k of the tetrahedron is a sheet, and its canonical name is this one.
  unsigned sheetsNamedAfter(Index tet) const { return this->State[tet] & (kTet - 1U); }

  bool keepsTriangle(Facet facet) const
  {
    return this->keptSides(facet) > 0 || this->isSheet(facet);
  }

  /// None of the triangle's sheets may be kept beside a kept tetrahedron: keepTet() leaves it to
  /// the caller to drop them, here and in dropTet() to keep them.
  void keepTet(Index tet) { this->State[tet] |= kTet; }
  void dropTet(Index tet) { this->State[tet] &= static_cast<std::uint8_t>(~kTet); }
  void keepSheet(Facet facet)
  {
    const Facet name = this->Flow->delaunay().canonical(facet);
    this->State[name / 4] |= static_cast<std::uint8_t>(1U << (name % 4));
  }
  void dropSheet(Facet facet)
  {
    const Facet name = this->Flow->delaunay().canonical(facet);
    this->State[name / 4] &= static_cast<std::uint8_t>(~(1U << (name % 4)));
  }

  /// Whether a tetrahedron is kept, and the sheets that are named after it, at once.
  void set(Index tet, bool keep, unsigned sheets)
  {
    this->State[tet] = static_cast<std::uint8_t>((keep ? kTet : 0U) | sheets);
  }

  /// Whether this is the union of the lower sets of the critical simplices in it, so that nothing
  /// can collapse. Whoever edits the complex says so.
  bool followsFlow() const { return this->FollowsFlow; }
  void setFollowsFlow(bool follows) { this->FollowsFlow = follows; }

  /// Whether another state of the same complex is equal from one tetrahedron up to another.
  bool isEqualIn(const WrapComplex& other, Index begin, Index end) const
  {
    return std::equal(
      this->State.begin() + begin, this->State.begin() + end, other.State.begin() + begin);
  }
  bool isEqualAt(const WrapComplex& other, Index tet) const
  {
    return this->State[tet] == other.State[tet];
  }

  friend bool operator==(const WrapComplex& a, const WrapComplex& b)
  {
    return a.Flow == b.Flow && a.State == b.State;
  }

private:
  static constexpr std::uint8_t kTet = 16;

  const FlowComplex* Flow;
  bool FollowsFlow = false;
  std::vector<std::uint8_t> State; ///< kTet; bit k: the canonical triangle k is a sheet
};

/// The Wrap complex: what remains of the Delaunay complex after all collapses possible from the
/// outside, which is the union of the lower sets of all critical simplices. It is contractible.
/// Linear time; two bytes of working memory a tetrahedron. Reports phase "collapse".
/// Edelsbrunner, "Surface reconstruction by wrapping finite sets in space" (2003);
/// Bauer, Edelsbrunner (2017), section 6.
WrapComplex collapseFromOutside(const FlowComplex& flow, Execution& execution);

/// All sheets by their canonical names, in increasing order.
std::vector<Facet> sheetsOf(const WrapComplex& wrap, Execution& execution);

/// The critical edges without a kept triangle. In the Wrap complex they are kept, as lines.
/// Smaller vertex first, sorted by vertices. Reports phase "edges".
std::vector<CriticalEdge> bareEdges(const WrapComplex& wrap, Execution& execution);

} // namespace scan
