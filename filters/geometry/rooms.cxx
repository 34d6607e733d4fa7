// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/rooms.h"

#include "filters/geometry/collect.h"
#include "filters/geometry/cut_cover.h"
#include "filters/geometry/incidence.h"
#include "filters/geometry/parallel_sort.h"
#include "filters/geometry/union_find.h"

#include <algorithm>
#include <limits>

namespace scan
{
namespace
{

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kSeedRatio = 1.1; // death / birth radius of a room that seeds the watershed

/// A critical triangle between two rooms, by the basins that stand for them.
struct Door
{
  double radius2;
  Facet facet;
  Index a;
  Index b;
};

/// The doors by decreasing radius. Basins that leave the hull count as the outside.
std::vector<Door> doorsByRadius(const FlowComplex& flow, const Basins& basins,
  const std::vector<Wall>& walls, Execution& execution)
{
  const DelaunayComplex& complex = flow.delaunay();
  const Index outside = basins.count();
  const auto room = [&](Index basin)
  { return basin == outside || basins.leavesHull(basin) ? outside : basin; };
  std::vector<Door> doors = collect<Door>(static_cast<Index>(walls.size()), execution,
    [&](Index w, auto& found)
    {
      const Index a = room(walls[w].a);
      const Index b = room(walls[w].b);
      if (a != b && flow.isCriticalTriangle(walls[w].facet))
      {
        found.push_back({ circumradiusSquared(complex, complex.facetVertices(walls[w].facet)),
          walls[w].facet, a, b });
      }
    });
  sortInParallel(doors, execution,
    [](const Door& p, const Door& q)
    { return p.radius2 != q.radius2 ? p.radius2 > q.radius2 : p.facet < q.facet; });
  return doors;
}

std::vector<double> sinkRadii2(const FlowComplex& flow, const Basins& basins)
{
  std::vector<double> death(basins.count() + 1, kInfinity);
  for (Index basin = 0; basin < basins.count(); ++basin)
  {
    if (!basins.leavesHull(basin))
    {
      death[basin] = circumradiusSquared(flow.delaunay(), basins.sink[basin]);
    }
  }
  return death;
}

std::vector<PersistencePair> pairsOf(
  const std::vector<Door>& doors, const Basins& basins, const std::vector<double>& death)
{
  std::vector<PersistencePair> pairs;
  UnionFind rooms(basins.count() + 1);
  for (const Door& door : doors)
  {
    Index elder = rooms.root(door.a);
    Index younger = rooms.root(door.b);
    if (elder == younger)
    {
      continue;
    }
    if (death[elder] < death[younger])
    {
      std::swap(elder, younger);
    }
    constexpr double kRounding = 1e-12;
    if (death[younger] > door.radius2 * (1.0 + kRounding))
    {
      pairs.push_back({ door.facet, basins.sink[younger], door.radius2, death[younger] });
    }
    rooms.join(elder, younger);
  }
  std::sort(pairs.begin(), pairs.end(),
    [](const PersistencePair& p, const PersistencePair& q)
    {
      const double left = p.death * q.birth;
      const double right = q.death * p.birth;
      return left != right ? left > right : p.sink < q.sink;
    });
  return pairs;
}

/// The rooms of the watershed: 0 is the outside, 1 the most persistent, and so on.
struct Rooms
{
  std::vector<Index> ofBasin; ///< and of the outside
  std::vector<double> ratio2; ///< (death / birth)^2 of each room's seed

  std::pair<Index, Index> of(const Wall& wall) const
  {
    return { this->ofBasin[wall.a], this->ofBasin[wall.b] };
  }
};

Rooms watershed(
  const std::vector<Door>& doors, const Basins& basins, const std::vector<PersistencePair>& pairs)
{
  Rooms rooms;
  rooms.ratio2.push_back(kInfinity);
  std::vector<Index> seed(basins.count() + 1, kNone); // per root: its room
  seed[basins.count()] = 0;
  for (const PersistencePair& pair : pairs)
  {
    if (pair.death > kSeedRatio * kSeedRatio * pair.birth)
    {
      seed[basins.ofTet[pair.sink]] = static_cast<Index>(rooms.ratio2.size());
      rooms.ratio2.push_back(pair.death / pair.birth);
    }
  }
  UnionFind regions(basins.count() + 1);
  for (const Door& door : doors)
  {
    const Index a = regions.root(door.a);
    const Index b = regions.root(door.b);
    if (a != b && (seed[a] == kNone || seed[b] == kNone))
    {
      regions.join(seed[a] != kNone ? a : b, seed[a] != kNone ? b : a);
    }
  }
  rooms.ofBasin.assign(basins.count() + 1, 0);
  for (Index basin = 0; basin < basins.count(); ++basin)
  {
    const Index room = basins.leavesHull(basin) ? 0 : seed[regions.root(basin)];
    rooms.ofBasin[basin] = room == kNone ? 0 : room;
  }
  return rooms;
}

/// Inside or outside: the most persistent room is inside, each other like the more persistent
/// room behind its widest door.
std::vector<std::uint8_t> firstGuess(const std::vector<Door>& doors, const Rooms& rooms)
{
  const auto count = static_cast<Index>(rooms.ratio2.size());
  std::vector<Index> opensTo(count, 0);
  std::vector<std::uint8_t> found(count, 0);
  for (const Door& door : doors) // widest first
  {
    const Index a = rooms.ofBasin[door.a];
    const Index b = rooms.ofBasin[door.b];
    if (a == b)
    {
      continue;
    }
    if (!found[a] && rooms.ratio2[b] >= rooms.ratio2[a])
    {
      found[a] = 1;
      opensTo[a] = b;
    }
    if (!found[b] && rooms.ratio2[a] >= rooms.ratio2[b])
    {
      found[b] = 1;
      opensTo[b] = a;
    }
  }
  std::vector<std::uint8_t> inside(count, 0);
  for (Index room = 1; room < count; ++room)
  {
    inside[room] = room == 1 ? 1 : inside[opensTo[room]];
  }
  return inside;
}

/// Flips rooms while that brings more points onto the surface.
class CoverageFlips
{
public:
  CoverageFlips(const DelaunayComplex& complex, const std::vector<Wall>& walls, const Rooms& rooms,
    std::vector<std::uint8_t> inside)
    : Complex(complex)
    , Inside(std::move(inside))
    , WallsOfRoom(Inside.size(), walls.size(),
        [&](std::size_t w, auto&& visit)
        {
          const auto [a, b] = rooms.of(walls[w]);
          if (a != b)
          {
            visit(a);
            visit(b);
          }
        })
    , Walls(walls)
    , TheRooms(rooms)
    , Cover(complex.points.size())
  {
    for (const Wall& wall : walls)
    {
      const auto [a, b] = rooms.of(wall);
      if (this->Inside[a] != this->Inside[b])
      {
        this->toggle(wall);
      }
    }
  }

  std::vector<std::uint8_t> run()
  {
    constexpr int kPasses = 3;
    bool changed = true;
    for (int pass = 0; pass < kPasses && changed; ++pass)
    {
      changed = false;
      for (Index room = 2; room < this->Inside.size(); ++room) // outside and first stay
      {
        if (this->flip(room) > 0)
        {
          changed = true;
        }
        else
        {
          this->flip(room);
        }
      }
    }
    return std::move(this->Inside);
  }

private:
  int flip(Index room) // returns the change in covered points
  {
    this->Inside[room] ^= 1U;
    int change = 0;
    for (const Index w : this->WallsOfRoom.of(room))
    {
      change += this->toggle(this->Walls[w]);
    }
    return change;
  }

  int toggle(const Wall& wall)
  {
    const auto [a, b] = this->TheRooms.of(wall);
    const int sign = this->Inside[a] != this->Inside[b] ? +1 : -1;
    return this->Cover.count(this->Complex.facetVertices(wall.facet), sign);
  }

  const DelaunayComplex& Complex;
  std::vector<std::uint8_t> Inside;
  Incidence WallsOfRoom;
  const std::vector<Wall>& Walls;
  const Rooms& TheRooms;
  CutCover Cover;
};

} // namespace

std::vector<PersistencePair> voidPersistence(const FlowComplex& flow, const Basins& basins,
  const std::vector<Wall>& walls, Execution& execution)
{
  return pairsOf(doorsByRadius(flow, basins, walls, execution), basins, sinkRadii2(flow, basins));
}

std::vector<std::uint8_t> persistentRooms(const FlowComplex& flow, const Basins& basins,
  const std::vector<Wall>& walls, Execution& execution)
{
  execution.step("rooms", 0, 3);
  const std::vector<Door> doors = doorsByRadius(flow, basins, walls, execution);
  execution.step("rooms", 1, 3);
  const Rooms rooms = watershed(doors, basins, pairsOf(doors, basins, sinkRadii2(flow, basins)));
  execution.step("rooms", 2, 3);
  const std::vector<std::uint8_t> inside =
    CoverageFlips(flow.delaunay(), walls, rooms, firstGuess(doors, rooms)).run();

  std::vector<std::uint8_t> insideBasin(basins.count());
  for (Index basin = 0; basin < basins.count(); ++basin)
  {
    insideBasin[basin] = inside[rooms.ofBasin[basin]];
  }
  execution.step("rooms", 3, 3);
  return insideBasin;
}

} // namespace scan
