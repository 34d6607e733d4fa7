// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/delaunay_complex.h"

#include <algorithm>
#include <span>
#include <unordered_set>
#include <vector>

namespace scan
{

/// Calls visit(tet) for all tetrahedra that have the given vertices, a face of `first`, each once
/// and `first` first, until it returns false. Returns false when stopped.
template <class Visit>
bool forEachTetAround(
  const DelaunayComplex& complex, std::span<const Index> face, Index first, Visit&& visit)
{
  std::unordered_set<Index> seen{ first };
  std::vector<Index> pending{ first };
  while (!pending.empty())
  {
    const Index tet = pending.back();
    pending.pop_back();
    if (!visit(tet))
    {
      return false;
    }
    for (int k = 0; k < 4; ++k)
    {
      const Index beyond = complex.neighbour(tet, k);
      if (beyond != kNone && std::ranges::find(face, complex.tetrahedra[tet][k]) == face.end() &&
        seen.insert(beyond).second)
      {
        pending.push_back(beyond);
      }
    }
  }
  return true;
}

} // namespace scan
