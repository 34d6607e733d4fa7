// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/outside_rooms.h"

#include "filters/geometry/collect.h"
#include "filters/geometry/half_edges.h"
#include "filters/geometry/open_surface.h"
#include "filters/geometry/union_find.h"

namespace scan
{
namespace
{

std::vector<Facet> hullFacets(const DelaunayComplex& complex, Execution& execution)
{
  return collect<Facet>(complex.tetCount(), execution,
    [&](Index tet, auto& found)
    {
      for (Facet facet = 4 * tet; facet < 4 * tet + 4; ++facet)
      {
        if (complex.mirror[tet][facet % 4] == kNone)
        {
          found.push_back(facet);
        }
      }
    });
}

} // namespace

OutsideRooms oneOutside(const DelaunayComplex& complex, Execution& execution)
{
  OutsideRooms outside;
  outside.facets = hullFacets(complex, execution);
  outside.room.assign(outside.facets.size(), 0);
  outside.side.assign(1, 0);
  return outside;
}

OutsideRooms denseOutside(
  const DelaunayComplex& complex, const std::vector<float>& spacing, Execution& execution)
{
  OutsideRooms outside;
  outside.facets = withoutOpenings(complex, spacing, hullFacets(complex, execution));
  TriMesh hull{ complex.points, {} };
  for (const Facet facet : outside.facets)
  {
    hull.triangles.push_back(complex.facetVertices(facet));
  }
  const std::vector<Index> mate = pairEdges(hull).mate;
  UnionFind pieces(outside.facets.size());
  for (Index half = 0; half < mate.size(); ++half)
  {
    if (mate[half] != kNone)
    {
      pieces.unite(half / 3, mate[half] / 3);
    }
  }
  outside.room.resize(outside.facets.size());
  for (Index f = 0; f < outside.facets.size(); ++f)
  {
    const Index first = pieces.root(f);
    if (first == f)
    {
      outside.room[f] = outside.count();
      outside.side.push_back(0);
    }
    outside.room[f] = outside.room[first];
  }
  return outside;
}

std::vector<Facet> cutTriangles(const DelaunayComplex& complex, const OutsideRooms& outside,
  const std::vector<std::uint8_t>& inside, Execution& execution)
{
  const auto isCut = [&](Facet facet, Index tet)
  {
    const Facet other = complex.mirror[tet][facet % 4];
    if (other != kNone)
    {
      return inside[tet] && !inside[other / 4];
    }
    const Index room = outside.beyond(facet);
    return room != kNone && inside[tet] != outside.side[room];
  };
  const bool allOutside = std::count(outside.side.begin(), outside.side.end(), 1) == 0;
  return collect<Facet>(complex.tetCount(), execution,
    [&](Index tet, auto& found)
    {
      if (!inside[tet] && allOutside)
      {
        return;
      }
      for (Facet facet = 4 * tet; facet < 4 * tet + 4; ++facet)
      {
        if (isCut(facet, tet))
        {
          found.push_back(facet);
        }
      }
    });
}

} // namespace scan
