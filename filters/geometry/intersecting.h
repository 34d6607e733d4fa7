// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/mend_surface.h"
#include "filters/geometry/region_adjacency.h"
#include "filters/geometry/self_intersections.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace scan
{

/// The intersections in which an active triangle takes part.
inline std::vector<TrianglePair> activeIntersections(
  const MendSurface& surface, Execution& execution)
{
  std::vector<Index> active;
  for (Index t = 0; t < surface.isActive.size(); ++t)
  {
    if (surface.isActive[t] != 0)
    {
      active.push_back(t);
    }
  }
  return selfIntersections(surface.mesh, active, execution);
}

/// The triangles of pairs, each once, rising.
inline std::vector<Index> trianglesOf(const std::vector<TrianglePair>& pairs)
{
  std::vector<Index> triangles;
  for (const auto& [a, b] : pairs)
  {
    triangles.insert(triangles.end(), { a, b });
  }
  std::ranges::sort(triangles);
  triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
  return triangles;
}

/// Per triangle 1 for those that are at most so many rings from the chosen ones.
inline std::vector<std::uint8_t> withRings(
  const TriMesh& mesh, const std::vector<Index>& chosen, std::size_t rings, Execution& execution)
{
  std::vector<std::uint8_t> isIn(mesh.triangles.size(), 0);
  for (const Index t : chosen)
  {
    isIn[t] = 1;
  }
  return RegionAdjacency(mesh, RegionElements::triangles, execution)
    .grow(std::move(isIn), rings, execution);
}

} // namespace scan
