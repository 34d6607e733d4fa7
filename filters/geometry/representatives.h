// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/facet_numbers.h"
#include "filters/geometry/flow_complex.h"
#include "filters/geometry/holders.h"
#include "filters/geometry/large_array.h"

namespace scan
{

/// For each upper simplex (holders.h) another one that stays exactly when it does, in every state
/// that follows the flow, where one is found. It is the only holder; or, of several, the only one
/// that holds none of the others: when any of them stays so does what that holds, and in the end
/// this one. What nothing critical holds has none: it goes with the collapse from outside.
class Representatives
{
public:
  /// A simplex as one number: a canonical facet, or a tetrahedron after all facets, or kNone.
  using Code = Index;

  static constexpr Index kMostTets = (kNone - 2) / 5; ///< that Code has room for

  /// Walks around every edge; five bytes a tetrahedron and four an obtuse triangle.
  /// For at most kMostTets.
  Representatives(const FlowComplex& flow, Execution& execution);

  /// Of a tetrahedron or free triangle; itself where there is no other one.
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

  void remember(Upper upper, Code code);

  const FlowComplex& Flow;
  Index FacetCount;
  FacetNumbers Obtuse; ///< free triangles that are not critical
  LargeArray<Code> OfTet;
  LargeArray<Code> OfObtuse;
};

} // namespace scan
