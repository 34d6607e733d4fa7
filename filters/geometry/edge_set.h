// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/mesh.h"

#include <algorithm>
#include <cstdint>
#include <unordered_map>

namespace scan
{

/// Edges between numbered points, either way round, each as often as it was added.
class EdgeSet
{
public:
  void add(Index a, Index b) { ++this->Counts[keyOf(a, b)]; }
  void remove(Index a, Index b)
  {
    if (const auto found = this->Counts.find(keyOf(a, b));
        found != this->Counts.end() && --found->second == 0)
    {
      this->Counts.erase(found);
    }
  }
  bool contains(Index a, Index b) const { return this->Counts.contains(keyOf(a, b)); }

private:
  static std::uint64_t keyOf(Index a, Index b)
  {
    const auto [low, high] = std::minmax(a, b);
    return (std::uint64_t{ high } << 32U) | low;
  }

  std::unordered_map<std::uint64_t, Index> Counts;
};

} // namespace scan
