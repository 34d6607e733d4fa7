// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/basins.h"

#include "filters/geometry/bounding_box.h"
#include "filters/geometry/collect.h"

#include <algorithm>
#include <cmath>

namespace scan
{
Basins findBasins(const FlowComplex& flow, Execution& execution)
{
  const DelaunayComplex& complex = flow.delaunay();
  execution.step("basins", 0, 2);
  LargeArray<Facet> exits(complex.tetCount()); // mirror of the exit facet, kNone where it ends
  execution.parallelFor(complex.tetCount(), 1 << 14,
    [&](std::size_t begin, std::size_t end)
    {
      for (auto tet = static_cast<Index>(begin); tet < end; ++tet)
      {
        exits[tet] = flow.isSink(tet) ? kNone : complex.mirror[tet][flow.exit(tet) % 4];
      }
    });
  execution.step("basins", 1, 2);
  Basins basins;
  basins.ofTet.assign(complex.tetCount(), kNone);
  const double cap = 0.5 * BoundingBox(complex.points).diagonal();
  std::vector<Index> path;
  for (Index tet = 0; tet < complex.tetCount(); ++tet)
  {
    Index current = tet;
    path.clear();
    while (basins.ofTet[current] == kNone)
    {
      path.push_back(current);
      if (exits[current] == kNone) // a sink, or the one tetrahedron of a hull triangle
      {
        basins.ofTet[current] = basins.count();
        basins.sink.push_back(flow.isSink(current) ? current : kNone);
        // the flow goes from small to large: it ends at the largest
        basins.size.push_back(std::min(cap, std::sqrt(circumradiusSquared(complex, current))));
        break;
      }
      current = exits[current] / 4;
    }
    for (const Index on : path)
    {
      basins.ofTet[on] = basins.ofTet[current];
    }
  }
  execution.step("basins", 2, 2);
  return basins;
}

std::vector<Wall> findWalls(const FlowComplex& flow, const Basins& basins, Execution& execution)
{
  const DelaunayComplex& complex = flow.delaunay();
  execution.step("walls", 0, 1);
  return collect<Wall>(complex.tetCount(), execution,
    [&](Index tet, auto& found)
    {
      const Index a = basins.ofTet[tet];
      for (unsigned k = 0; k < 4; ++k)
      {
        const Facet mirror = complex.mirror[tet][k];
        const Index b = mirror == kNone ? basins.count() : basins.ofTet[mirror / 4];
        if (a != b && 4 * tet + k < mirror)
        {
          found.push_back({ 4 * tet + k, a, b });
        }
      }
    });
}

} // namespace scan
