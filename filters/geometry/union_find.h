// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/mesh.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace scan
{

/// Disjoint sets with path halving; the caller says which root survives a join.
class UnionFind
{
public:
  explicit UnionFind(std::size_t count)
    : Parent(count)
  {
    std::iota(this->Parent.begin(), this->Parent.end(), Index{ 0 });
  }

  Index root(Index element)
  {
    while (this->Parent[element] != element)
    {
      this->Parent[element] = this->Parent[this->Parent[element]];
      element = this->Parent[element];
    }
    return element;
  }

  /// Both arguments are roots.
  void join(Index survivor, Index other) { this->Parent[other] = survivor; }

  /// Joins the sets of two elements; the smaller of their roots survives.
  void unite(Index a, Index b)
  {
    const auto [low, high] = std::minmax({ this->root(a), this->root(b) });
    this->join(low, high);
  }

private:
  std::vector<Index> Parent;
};

} // namespace scan
