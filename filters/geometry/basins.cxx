// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/basins.h"

#include "filters/geometry/union_find.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace scan
{
namespace
{

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kSeedRatio = 1.1; // death / birth radius of a room that seeds the watershed

double halfDiagonal(const std::vector<Vec3>& points)
{
  Vec3 low = points.front();
  Vec3 high = low;
  for (const Vec3& p : points)
  {
    low = { std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z) };
    high = { std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z) };
  }
  return 0.5 * std::sqrt(dot(high - low, high - low));
}

/// A critical triangle between two basins; `outside` stands for all that lies beyond the hull.
struct Door
{
  double radius2;
  Facet facet;
  Index a;
  Index b;
};

/// The doors by decreasing radius. Basins that leave the hull count as the outside.
std::vector<Door> doorsByRadius(const FlowComplex& flow, const Basins& basins)
{
  const DelaunayComplex& complex = flow.delaunay();
  const Index outside = basins.count();
  const auto roomOf = [&](Index tet)
  {
    const Index basin = tet == kNone ? outside : basins.ofTet[tet];
    return basin == outside || basins.leavesHull(basin) ? outside : basin;
  };
  std::vector<Door> doors;
  for (Facet facet = 0; facet < 4 * complex.tetCount(); ++facet)
  {
    if (complex.canonical(facet) != facet)
    {
      continue;
    }
    const Index a = roomOf(facet / 4);
    const Index b = roomOf(complex.neighbour(facet / 4, static_cast<int>(facet % 4)));
    if (a != b && flow.isCriticalTriangle(facet))
    {
      doors.push_back({ circumradiusSquared(complex, complex.facetVertices(facet)), facet, a, b });
    }
  }
  std::sort(doors.begin(), doors.end(),
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
  std::vector<Index> ofBasin;
  std::vector<double> ratio2; ///< (death / birth)^2 of each room's seed
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
  rooms.ofBasin.resize(basins.count());
  for (Index basin = 0; basin < basins.count(); ++basin)
  {
    const Index room = basins.leavesHull(basin) ? 0 : seed[regions.root(basin)];
    rooms.ofBasin[basin] = room == kNone ? 0 : room;
  }
  return rooms;
}

/// Inside or outside: the most persistent room is inside, each other like the more persistent
/// room behind its widest door.
std::vector<std::uint8_t> firstGuess(
  const std::vector<Door>& doors, const Rooms& rooms, Index outside)
{
  const auto count = static_cast<Index>(rooms.ratio2.size());
  const auto roomOf = [&](Index basin) { return basin == outside ? 0 : rooms.ofBasin[basin]; };
  std::vector<Index> opensTo(count, 0);
  std::vector<std::uint8_t> found(count, 0);
  for (const Door& door : doors) // widest first
  {
    const Index a = roomOf(door.a);
    const Index b = roomOf(door.b);
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
void flipForCoverage(const FlowComplex& flow, const Basins& basins, const Rooms& rooms,
  std::vector<std::uint8_t>& inside)
{
  const DelaunayComplex& complex = flow.delaunay();
  const auto roomOf = [&](Index tet)
  { return tet == kNone ? 0 : rooms.ofBasin[basins.ofTet[tet]]; };
  struct Wall
  {
    Facet facet;
    Index a;
    Index b;
  };
  std::vector<Wall> walls;
  for (Facet facet = 0; facet < 4 * complex.tetCount(); ++facet)
  {
    const Index a = roomOf(facet / 4);
    const Index b = roomOf(complex.neighbour(facet / 4, static_cast<int>(facet % 4)));
    if (a != b && complex.canonical(facet) == facet)
    {
      walls.push_back({ facet, a, b });
    }
  }
  const auto count = static_cast<Index>(inside.size());
  std::vector<Index> first(count + 1, 0); // walls of each room
  for (const Wall& wall : walls)
  {
    ++first[wall.a];
    ++first[wall.b];
  }
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<Index> wallsOf(first.back());
  for (Index w = 0; w < walls.size(); ++w)
  {
    wallsOf[--first[walls[w].a]] = w;
    wallsOf[--first[walls[w].b]] = w;
  }

  std::vector<Index> cutTriangles(complex.points.size(), 0); // at each vertex
  const auto toggle = [&](const Wall& wall) {                // returns the change in covered points
    const bool cuts = inside[wall.a] != inside[wall.b];
    int change = 0;
    for (const Index v : complex.facetVertices(wall.facet))
    {
      change += cuts ? (cutTriangles[v]++ == 0 ? 1 : 0) : (--cutTriangles[v] == 0 ? -1 : 0);
    }
    return change;
  };
  for (const Wall& wall : walls)
  {
    if (inside[wall.a] != inside[wall.b])
    {
      toggle(wall);
    }
  }
  const auto flip = [&](Index room)
  {
    inside[room] ^= 1U;
    int change = 0;
    for (Index i = first[room]; i < first[room + 1]; ++i)
    {
      change += toggle(walls[wallsOf[i]]);
    }
    return change;
  };
  constexpr int kPasses = 3;
  bool changed = true;
  for (int pass = 0; pass < kPasses && changed; ++pass)
  {
    changed = false;
    for (Index room = 2; room < count; ++room)
    {
      if (flip(room) > 0)
      {
        changed = true;
      }
      else
      {
        flip(room);
      }
    }
  }
}

} // namespace

Basins findBasins(const FlowComplex& flow, Execution& execution)
{
  const DelaunayComplex& complex = flow.delaunay();
  Basins basins;
  basins.ofTet.assign(complex.tetCount(), kNone);
  std::vector<Index> path;
  for (Index tet = 0; tet < complex.tetCount(); ++tet)
  {
    if (tet % 65536 == 0)
    {
      execution.step("basins", tet, complex.tetCount());
    }
    Index current = tet;
    path.clear();
    Index basin = basins.ofTet[current];
    while (basin == kNone)
    {
      path.push_back(current);
      const Index beyond =
        flow.isSink(current) ? kNone : complex.mirror[current][flow.exit(current) % 4];
      if (beyond == kNone) // a hull triangle has one tetrahedron, so this one opens the basin
      {
        basin = basins.count();
        basins.sink.push_back(flow.isSink(current) ? current : kNone);
        break;
      }
      current = beyond / 4;
      basin = basins.ofTet[current];
    }
    for (const Index on : path)
    {
      basins.ofTet[on] = basin;
    }
  }
  const double cap = halfDiagonal(complex.points);
  basins.size.assign(basins.count(), 0.0);
  for (Index tet = 0; tet < complex.tetCount(); ++tet)
  {
    double& size = basins.size[basins.ofTet[tet]];
    size = std::max(size, circumradiusSquared(complex, tet));
  }
  for (double& size : basins.size)
  {
    size = std::min(cap, std::sqrt(size));
  }
  return basins;
}

std::vector<PersistencePair> voidPersistence(
  const FlowComplex& flow, const Basins& basins, Execution& execution)
{
  execution.step("rooms", 0, 1);
  return pairsOf(doorsByRadius(flow, basins), basins, sinkRadii2(flow, basins));
}

std::vector<std::uint8_t> persistentRooms(
  const FlowComplex& flow, const Basins& basins, Execution& execution)
{
  execution.step("rooms", 0, 4);
  const std::vector<Door> doors = doorsByRadius(flow, basins);
  execution.step("rooms", 1, 4);
  const auto pairs = pairsOf(doors, basins, sinkRadii2(flow, basins));
  execution.step("rooms", 2, 4);
  const Rooms rooms = watershed(doors, basins, pairs);
  std::vector<std::uint8_t> inside = firstGuess(doors, rooms, basins.count());
  execution.step("rooms", 3, 4);
  flipForCoverage(flow, basins, rooms, inside);

  std::vector<std::uint8_t> insideBasin(basins.count());
  for (Index basin = 0; basin < basins.count(); ++basin)
  {
    insideBasin[basin] = inside[rooms.ofBasin[basin]];
  }
  execution.step("rooms", 4, 4);
  return insideBasin;
}

} // namespace scan
