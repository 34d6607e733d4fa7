// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/facet_marks.h"
#include "filters/geometry/flow_complex.h"
#include "filters/geometry/holders.h"

#include <vector>

namespace scan
{

/// On which upper simplex each other one hangs alone: its outermost dominator in the relation of
/// holders. When that one stays so does the other, when it goes so does the other.
class Dominators
{
public:
  /// A dominator as one number: a canonical facet, or a tetrahedron after all facets, or kNone for
  /// what nothing critical holds: it goes with the collapse from outside.
  using Code = Index;

  static constexpr Index kMostTets = (kNone - 2) / 5; ///< that Code has room for

  /// Linear time; five bytes a tetrahedron. For at most kMostTets.
  Dominators(const FlowComplex& flow, Execution& execution);

  /// Of a tetrahedron or free triangle; itself where it is critical or hangs on several. Itself,
  /// too, for a tetrahedron that hangs on a triangle, and for a triangle that hangs on something
  /// that the tetrahedra beside it do not hang on: there are few.
  Code of(Upper upper) const;

  Code codeOf(Upper upper) const
  {
    return upper.isTet ? this->FacetCount + upper.name : upper.name;
  }
  Upper at(Code code) const
  {
    return code < this->FacetCount ? Upper{ false, code } : Upper{ true, code - this->FacetCount };
  }

private:
  class Search;

  Code beside(Facet triangle) const;
  void remember(Upper upper, Code code);

  const FlowComplex& Flow;
  Index FacetCount;
  std::vector<Code> OfTet;
  FacetMarks OfTriangle; ///< at canonical free facets
};

} // namespace scan
