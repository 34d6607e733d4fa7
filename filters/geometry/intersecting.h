// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/mend_surface.h"
#include "filters/geometry/self_intersections.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace scan
{

/// The intersections in which an active triangle takes part.
inline std::vector<TrianglePair> activeIntersections(
  const MendSurface& surface, Execution& execution)
{
  std::vector<TrianglePair> pairs = selfIntersections(surface.mesh, execution);
  std::erase_if(pairs,
    [&](const TrianglePair& pair)
    { return surface.isActive[pair[0]] == 0 && surface.isActive[pair[1]] == 0; });
  return pairs;
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
  const TriMesh& mesh, const std::vector<Index>& chosen, int rings)
{
  std::vector<std::uint8_t> isIn(mesh.triangles.size(), 0);
  std::vector<std::uint8_t> isPointIn(mesh.points.size(), 0);
  for (const Index t : chosen)
  {
    isIn[t] = 1;
  }
  for (int ring = 0; ring < rings; ++ring)
  {
    for (std::size_t t = 0; t < isIn.size(); ++t)
    {
      if (isIn[t] != 0)
      {
        std::ranges::for_each(mesh.triangles[t], [&](Index point) { isPointIn[point] = 1; });
      }
    }
    for (std::size_t t = 0; t < isIn.size(); ++t)
    {
      const auto& [a, b, c] = mesh.triangles[t];
      isIn[t] = (isIn[t] | isPointIn[a] | isPointIn[b] | isPointIn[c]) != 0 ? 1 : 0;
    }
  }
  return isIn;
}

} // namespace scan
