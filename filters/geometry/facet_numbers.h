// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/delaunay_complex.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <vector>

namespace scan
{

/// Some canonical facets, numbered from 0 in increasing order. 0.75 bytes a tetrahedron.
class FacetNumbers
{
public:
  /// @param isIn (canonical facet) -> bool; several threads call it
  template <class IsIn>
  FacetNumbers(const DelaunayComplex& complex, Execution& execution, IsIn&& isIn)
    : Words(complex.tetCount() / kTetsAWord + 1, 0)
    , Before(this->Words.size() + 1, 0)
  {
    constexpr std::size_t kGrain = 1 << 10;
    const std::size_t facetCount = std::size_t{ 4 } * complex.tetCount();
    execution.parallelFor(this->Words.size(), kGrain,
      [&](std::size_t begin, std::size_t end)
      {
        const std::size_t last = std::min(kBits * end, facetCount);
        for (auto facet = static_cast<Facet>(kBits * begin); facet < last; ++facet)
        {
          const bool belongs = complex.canonical(facet) == facet && isIn(facet);
          this->Words[facet / kBits] |= std::uint64_t{ belongs } << (facet % kBits);
        }
      });
    for (std::size_t i = 0; i < this->Words.size(); ++i)
    {
      this->Before[i + 1] = this->Before[i] + static_cast<Index>(std::popcount(this->Words[i]));
    }
  }

  Index count() const { return this->Before.back(); }

  bool contains(Facet canonical) const
  {
    return (this->Words[canonical / kBits] >> (canonical % kBits) & 1U) != 0;
  }

  /// The number of a facet, or of the first one after it, up to one past all facets.
  Index of(Facet facet) const
  {
    const std::uint64_t before = (std::uint64_t{ 1 } << (facet % kBits)) - 1;
    return this->Before[facet / kBits] +
      static_cast<Index>(std::popcount(this->Words[facet / kBits] & before));
  }

  /// Bit k of a word: facet kBits * word + k.
  static constexpr Facet kBits = 64;
  Index wordCount() const { return static_cast<Index>(this->Words.size()); }
  std::uint64_t word(Index i) const { return this->Words[i]; }

private:
  static constexpr Index kTetsAWord = kBits / 4;

  std::vector<std::uint64_t> Words; ///< a bit a facet
  std::vector<Index> Before;        ///< how many there are before each word
};

} // namespace scan
