// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/mesh.h"

#include <numeric>
#include <span>
#include <vector>

namespace scan
{

/// For each of `count` owners the numbers of its items.
class Incidence
{
public:
  Incidence() = default;

  /// ownersOf(item, visit) calls visit(owner) for each owner of the item.
  template <class OwnersOf>
  Incidence(std::size_t count, std::size_t items, OwnersOf&& ownersOf)
    : First(count + 1, 0)
  {
    for (std::size_t item = 0; item < items; ++item)
    {
      ownersOf(item, [&](Index owner) { ++this->First[owner]; });
    }
    std::partial_sum(this->First.begin(), this->First.end(), this->First.begin());
    this->Items.resize(this->First.back());
    for (std::size_t item = 0; item < items; ++item)
    {
      ownersOf(
        item, [&](Index owner) { this->Items[--this->First[owner]] = static_cast<Index>(item); });
    }
  }

  std::size_t owners() const { return this->First.size() - 1; }

  std::span<const Index> of(Index owner) const
  {
    return { this->Items.data() + this->First[owner], this->Items.data() + this->First[owner + 1] };
  }

  /// All items by owner, those of each in decreasing order; where they begin, and the end.
  const std::vector<Index>& items() const { return this->Items; }
  const std::vector<Index>& begins() const { return this->First; }

private:
  std::vector<Index> First{ 0 };
  std::vector<Index> Items;
};

} // namespace scan
