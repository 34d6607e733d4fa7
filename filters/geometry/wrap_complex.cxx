// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/wrap_complex.h"

#include "filters/base/error.h"
#include "filters/geometry/collect.h"
#include "filters/geometry/interval_fates.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace scan
{

WrapComplex::WrapComplex(const FlowComplex& flow, std::vector<std::uint8_t> bytes, bool followsFlow)
  : Flow(&flow)
  , FollowsFlow(followsFlow)
  , State(std::move(bytes))
{
  constexpr std::uint8_t kHighest = 2 * kTet - 1;
  if (this->State.size() != flow.delaunay().tetCount() ||
    std::ranges::any_of(this->State, [](std::uint8_t state) { return state > kHighest; }))
  {
    throw Error(ErrorCode::badInput, "the state of the wrap is damaged; wrap the points again");
  }
}

WrapComplex collapseFromOutside(const FlowComplex& flow, Execution& execution)
{
  const DelaunayComplex& complex = flow.delaunay();
  execution.step("collapse", 0, 1);
  IntervalFates fates(complex.tetCount());
  WrapComplex wrap(flow);
  execution.parallelFor(complex.tetCount(), 1 << 14,
    [&](std::size_t begin, std::size_t end)
    {
      FateSearch search(flow, fates);
      for (auto tet = static_cast<Index>(begin); tet < end; ++tet)
      {
        if (search.stays({ true, tet }))
        {
          wrap.keepTet(tet); // and with it its triangles
          continue;
        }
        for (Facet facet = 4 * tet; facet < 4 * tet + 4; ++facet)
        {
          const Index beyond = complex.neighbour(tet, static_cast<int>(facet % 4));
          if (complex.canonical(facet) == facet && flow.isFree(facet) &&
            (beyond == kNone || !search.stays({ true, beyond })) && search.stays({ false, facet }))
          {
            wrap.keepSheet(facet);
          }
        }
      }
    });
  wrap.setFollowsFlow(true);
  return wrap;
}

std::vector<Facet> sheetsOf(const WrapComplex& wrap, Execution& execution)
{
  return collect<Facet>(wrap.flow().delaunay().tetCount(), execution,
    [&](Index tet, auto& found)
    {
      for (unsigned named = wrap.sheetsNamedAfter(tet); named != 0; named &= named - 1)
      {
        found.push_back(4 * tet + static_cast<Facet>(std::countr_zero(named)));
      }
    });
}

std::vector<CriticalEdge> bareEdges(const WrapComplex& wrap, Execution& execution)
{
  std::vector<CriticalEdge> bare;
  const DelaunayComplex& complex = wrap.flow().delaunay();
  const auto isGone = [&](Facet facet) { return !wrap.keepsTriangle(facet); };
  for (CriticalEdge& edge : criticalEdges(wrap.flow(), execution, isGone))
  {
    if (complex.walkWholeEdge(
          edge.triangle, edge.apex, [&](Facet, Facet leaving, Facet) { return isGone(leaving); }))
    {
      std::ranges::sort(edge.vertices);
      bare.push_back(edge);
    }
  }
  std::ranges::sort(bare, {}, &CriticalEdge::vertices);
  return bare;
}

} // namespace scan
