// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/delaunay_cells.h"

#include "filters/base/error.h"
#include "filters/geometry/delaunay_predicates.h"

#include <algorithm>
#include <utility>

namespace scan
{

DelaunayCells::DelaunayCells(std::span<const Vec3> all, std::array<Index, 4> corners)
  : points(all)
{
  constexpr std::size_t kCellsPerPoint = 7; // of a scan; more are made room for later
  this->makeRoom(kCellsPerPoint * all.size() + 8 * std::size_t{ kBlock });
  if (orientation(all[corners[0]], all[corners[1]], all[corners[2]], all[corners[3]]) < 0)
  {
    std::swap(corners[0], corners[1]);
  }
  // cell 0 is the tetrahedron, cell 1 + k lies between its facet k and infinity
  this->Used = 5;
  std::fill_n(this->marks.begin(), 5, std::uint16_t{ 0 });
  this->cells[0].vertices = corners;
  for (Index k = 0; k < 4; ++k)
  {
    const auto& f = kFacetVertices[k];
    this->cells[1 + k].vertices = { corners[f[0]], corners[f[1]], corners[f[2]],
      DelaunayCell::kInfinity };
    this->cells[0].mirror[k] = 4 * (1 + k) + 3;
    this->cells[1 + k].mirror[3] = k;
    for (Facet i = 0; i < 3; ++i) // across the edge opposite f[i]: the cell at facet f[i]
    {
      const auto& other = kFacetVertices[f[i]];
      const auto back = std::find(other.begin(), other.end(), static_cast<int>(k)) - other.begin();
      this->cells[1 + k].mirror[i] = 4 * static_cast<Facet>(1 + f[i]) + static_cast<Facet>(back);
    }
  }
}

Index DelaunayCells::takeBlock()
{
  const Index first = this->Used.fetch_add(kBlock, std::memory_order_relaxed);
  if (first + kBlock > this->cells.size())
  {
    this->Used.fetch_sub(kBlock, std::memory_order_relaxed);
    return kNone;
  }
  for (Index cell = first; cell < first + kBlock; ++cell)
  {
    this->cells[cell].setFree();
  }
  return first;
}

void DelaunayCells::makeRoom(std::size_t more)
{
  const std::size_t needed = this->used() + more;
  if (needed > this->cells.size())
  {
    if (needed > kNone / 4)
    {
      throw Error(ErrorCode::limit, "more than 2^30 tetrahedra; thin the scan first");
    }
    const std::size_t roomy =
      std::min<std::size_t>(kNone / 4, std::max(needed, this->cells.size() / 4 * 5));
    this->cells.resize(roomy);
    constexpr std::uint16_t kNeverUsed = 0xffff;
    this->marks.resize(roomy, kNeverUsed);
  }
}

} // namespace scan
