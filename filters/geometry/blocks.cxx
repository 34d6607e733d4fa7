// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/blocks.h"

#include "filters/geometry/collect.h"
#include "filters/geometry/incidence.h"
#include "filters/geometry/parallel_sort.h"
#include "filters/geometry/union_find.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <utility>

namespace scan
{
namespace
{

constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::vector<Door> findDoors(const Blocks& blocks, Execution& execution)
{
  const FlowComplex& flow = blocks.flow();
  const DelaunayComplex& complex = flow.delaunay();
  return collect<Door>(complex.tetCount(), execution,
    [&](Index tet, auto& found)
    {
      const Index a = blocks.ofTet(tet);
      for (Facet facet = 4 * tet; facet < 4 * tet + 4; ++facet)
      {
        const Index beyond = complex.neighbour(tet, static_cast<int>(facet % 4));
        const Index b = beyond == kNone ? blocks.outside() : blocks.ofTet(beyond);
        if (a != b && complex.canonical(facet) == facet && flow.isCriticalTriangle(facet))
        {
          found.push_back({ facet, a, b, circumradius(complex, facet) });
        }
      }
    });
}

} // namespace

Blocks::Blocks(const FlowComplex& flow, const Basins& basins, Execution& execution)
  : Flow(flow)
  , TheBasins(basins)
  , TetCount(basins.count() + 1, 0)
  , Size(basins.count() + 1, kInfinity)
  , Persistence(basins.count() + 1, 1.0)
  , Opening(basins.count() + 1, kInfinity)
{
  execution.step("blocks", 0, 3);
  for (const Index basin : basins.ofTet)
  {
    ++this->TetCount[basin];
  }
  for (Index block = 0; block < basins.count(); ++block)
  {
    if (this->isVolume(block))
    {
      this->Size[block] = std::sqrt(circumradiusSquared(flow.delaunay(), basins.sink[block]));
    }
  }
  this->Doors = findDoors(*this, execution);
  execution.step("blocks", 1, 3);
  this->listWays(execution);
  execution.step("blocks", 2, 3);
  this->measureOpenings(execution);
  execution.step("blocks", 3, 3);
}

void Blocks::listWays(Execution& execution)
{
  const Incidence doorsOf(this->outside(), this->Doors.size(),
    [&](std::size_t d, auto&& visit)
    {
      for (const Index block : { this->Doors[d].a, this->Doors[d].b })
      {
        if (block != this->outside())
        {
          visit(block);
        }
      }
    });
  std::vector<double> width(this->Doors.size()); // compared with the smaller room
  for (std::size_t d = 0; d < width.size(); ++d)
  {
    const Door& door = this->Doors[d];
    width[d] = door.radius / std::min(this->Size[door.a], this->Size[door.b]);
  }
  this->FirstWay = doorsOf.begins();
  this->Ways.resize(this->FirstWay.back());
  execution.parallelFor(this->outside(), 64,
    [&](std::size_t begin, std::size_t end)
    {
      for (auto block = static_cast<Index>(begin); block < end; ++block)
      {
        const auto first = this->Ways.begin() + this->FirstWay[block];
        const auto last = std::ranges::transform(doorsOf.of(block), first,
          [&](Index d)
          {
            const Door& door = this->Doors[d];
            return Way{ d, door.a == block ? door.b : door.a, door.radius };
          }).out;
        std::sort(first, last,
          [&](const Way& p, const Way& q) {
            return width[p.door] != width[q.door] ? width[p.door] > width[q.door] : p.door < q.door;
          });
      }
    });
}

/// Kruskal over the doors from wide to narrow: where two rooms meet, the smaller one dies
/// (persistence); where one of them is the outside, the other opens.
void Blocks::measureOpenings(Execution& execution)
{
  std::vector<std::pair<double, Index>> byRadius(this->Doors.size()); // negative: wide first
  for (Index d = 0; d < byRadius.size(); ++d)
  {
    byRadius[d] = { -this->Doors[d].radius, d };
  }
  sortInParallel(byRadius, execution, std::less<>());

  UnionFind rooms(this->Size.size());
  std::vector<Index> next(this->Size.size()); // the members of a room in a ring
  std::iota(next.begin(), next.end(), Index{ 0 });
  const auto isOpen = [&](Index room) { return rooms.root(this->outside()) == room; };
  for (const auto& [negative, d] : byRadius)
  {
    const Door& door = this->Doors[d];
    Index elder = rooms.root(door.a);
    Index younger = rooms.root(door.b);
    if (elder == younger)
    {
      continue;
    }
    if (this->Size[elder] < this->Size[younger])
    {
      std::swap(elder, younger);
    }
    this->Persistence[younger] = std::max(1.0, this->Size[younger] / door.radius);
    if (isOpen(elder))
    {
      Index member = younger;
      do
      {
        this->Opening[member] = door.radius;
        member = next[member];
      } while (member != younger);
    }
    std::swap(next[elder], next[younger]);
    rooms.join(elder, younger);
  }
}

} // namespace scan
