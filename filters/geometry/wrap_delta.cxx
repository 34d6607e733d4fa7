// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/wrap_delta.h"

#include "filters/base/error.h"

#include <numeric>

namespace scan
{

namespace
{

constexpr unsigned kTet = 16;
constexpr unsigned kSheets = 15;

/// Calls visit(tetrahedron, place): the places go from basin to basin.
template <class Visit>
void forEachByBasin(const Basins& basins, const Visit& visit)
{
  std::vector<Index> next(static_cast<std::size_t>(basins.count()) + 1, 0);
  for (const Index basin : basins.ofTet)
  {
    ++next[basin + 1];
  }
  std::partial_sum(next.begin(), next.end(), next.begin());
  for (Index tet = 0; tet < basins.ofTet.size(); ++tet)
  {
    visit(tet, next[basins.ofTet[tet]]++);
  }
}

/// The state with other tetrahedra kept, and the sheets to expect then.
/// @param keeps per tetrahedron, whether it is kept
template <class Keeps>
WrapComplex expected(const WrapComplex& from, const Keeps& keeps)
{
  const Index tets = from.flow().delaunay().tetCount();
  WrapComplex state = from;
  for (Index tet = 0; tet < tets; ++tet)
  {
    if (keeps(tet) != from.keepsTet(tet))
    {
      keeps(tet) ? state.keepTet(tet) : state.dropTet(tet);
    }
  }
  for (Index tet = 0; tet < tets; ++tet)
  {
    for (Facet facet = 4 * tet; state.keepsTet(tet) != from.keepsTet(tet) && facet < 4 * tet + 4;
         ++facet)
    {
      if (state.keptSides(facet) > 0)
      {
        state.dropSheet(facet);
      }
      else if (from.keptSides(facet) == 1)
      {
        state.keepSheet(facet);
      }
    }
  }
  return state;
}

} // namespace

std::vector<std::uint8_t> deltaOf(
  const WrapComplex& from, const WrapComplex& to, const Basins& basins)
{
  const WrapComplex guess = expected(from, [&](Index tet) { return to.keepsTet(tet); });
  std::vector<std::uint8_t> delta(to.bytes().size());
  forEachByBasin(basins,
    [&](Index tet, Index place)
    {
      delta[place] = static_cast<std::uint8_t>(((from.bytes()[tet] ^ to.bytes()[tet]) & kTet) |
        ((guess.bytes()[tet] ^ to.bytes()[tet]) & kSheets));
    });
  return delta;
}

WrapComplex applyDelta(const WrapComplex& from, std::span<const std::uint8_t> delta,
  const Basins& basins, bool followsFlow)
{
  if (delta.size() != from.bytes().size())
  {
    throw Error(ErrorCode::badInput, "the state of the wrap is damaged; wrap the points again");
  }
  std::vector<std::uint8_t> byTet(delta.size());
  forEachByBasin(basins, [&](Index tet, Index place) { byTet[tet] = delta[place]; });
  const WrapComplex guess =
    expected(from, [&](Index tet) { return from.keepsTet(tet) != ((byTet[tet] & kTet) != 0); });
  for (std::size_t tet = 0; tet < byTet.size(); ++tet)
  {
    byTet[tet] = static_cast<std::uint8_t>((byTet[tet] & kSheets) ^ guess.bytes()[tet]);
  }
  return { from.flow(), std::move(byTet), followsFlow };
}

} // namespace scan
