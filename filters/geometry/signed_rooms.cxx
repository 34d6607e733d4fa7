// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/signed_rooms.h"

#include "filters/geometry/facet_radius.h"
#include "filters/geometry/incidence.h"
#include "filters/geometry/union_find.h"

#include <algorithm>
#include <cmath>

namespace scan
{
namespace
{

/// What two basins wish: opposite labels when positive, the same when negative.
struct Wish
{
  Index a;
  Index b; ///< a < b
  double weight;
};

double area(const DelaunayComplex& complex, Facet facet)
{
  const Triangle v = complex.facetVertices(facet);
  const Vec3& p = complex.points[v[0]];
  const Vec3 normal = cross(complex.points[v[1]] - p, complex.points[v[2]] - p);
  return 0.5 * std::sqrt(dot(normal, normal));
}

/// One wall's share of the wish of its two basins.
Wish wishOfWall(const FlowComplex& flow, const Basins& basins, const Wall& wall)
{
  constexpr double kMostLog = 3.0;
  constexpr double kDoorLog = 1.0; // less than e times as roomy: a door
  const bool onHull = wall.b >= basins.count();
  const double room =
    onHull ? basins.size[wall.a] : std::min(basins.size[wall.a], basins.size[wall.b]);
  const double radius = std::sqrt(facetRadiusSquared(flow, wall.facet));
  const double log = std::min(kMostLog, std::log(room / std::min(room, radius)));
  return { std::min(wall.a, wall.b), std::max(wall.a, wall.b),
    area(flow.delaunay(), wall.facet) * (log - kDoorLog) };
}

/// The wishes of all pairs of basins with common walls, by pairs.
std::vector<Wish> wishesOf(const FlowComplex& flow, const Basins& basins,
  const std::vector<Wall>& walls, Execution& execution)
{
  std::vector<Wish> wishes(walls.size());
  execution.parallelFor(walls.size(), 1 << 13,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t w = begin; w < end; ++w)
      {
        wishes[w] = wishOfWall(flow, basins, walls[w]);
      }
    });
  const auto samePair = [](const Wish& p, const Wish& q) { return p.a == q.a && p.b == q.b; };
  std::stable_sort(wishes.begin(), wishes.end(),
    [](const Wish& p, const Wish& q) { return p.a != q.a ? p.a < q.a : p.b < q.b; });
  std::size_t last = 0;
  for (std::size_t w = 1; w < wishes.size(); ++w)
  {
    if (samePair(wishes[last], wishes[w]))
    {
      wishes[last].weight += wishes[w].weight;
    }
    else
    {
      wishes[++last] = wishes[w];
    }
  }
  wishes.resize(std::min(wishes.size(), last + 1));
  return wishes;
}

/// Grants wishes by decreasing weight unless they contradict what was granted before. Every basin
/// stands twice in the sets, as itself and as its opposite.
std::vector<std::uint8_t> grant(std::vector<Wish> wishes, Index count)
{
  std::sort(wishes.begin(), wishes.end(),
    [](const Wish& p, const Wish& q)
    {
      const double left = std::abs(p.weight);
      const double right = std::abs(q.weight);
      return left != right ? left > right : p.a != q.a ? p.a < q.a : p.b < q.b;
    });
  UnionFind sets(2 * std::size_t{ count });
  for (const Wish& wish : wishes)
  {
    const Index opposite = wish.weight > 0.0 ? 1 : 0;
    const Index a = sets.root(2 * wish.a);
    if (a != sets.root(2 * wish.b) && a != sets.root(2 * wish.b + 1))
    {
      sets.join(a, sets.root(2 * wish.b + opposite));
      sets.join(sets.root(2 * wish.a + 1), sets.root(2 * wish.b + 1 - opposite));
    }
  }
  std::vector<std::uint8_t> label(count);
  for (Index basin = 0; basin < count; ++basin)
  {
    label[basin] = sets.root(2 * basin) < sets.root(2 * basin + 1) ? 0 : 1;
  }
  return label;
}

/// Flips single basins while the granted weight grows.
void flipBasins(const std::vector<Wish>& wishes, std::vector<std::uint8_t>& label)
{
  const Incidence wishesOfBasin(label.size(), wishes.size(),
    [&](std::size_t w, auto&& visit)
    {
      visit(wishes[w].a);
      visit(wishes[w].b);
    });
  constexpr int kPasses = 50;
  bool changed = true;
  for (int pass = 0; pass < kPasses && changed; ++pass)
  {
    changed = false;
    for (Index basin = 0; basin < label.size(); ++basin)
    {
      double gain = 0.0;
      double total = 0.0;
      for (const Index w : wishesOfBasin.of(basin))
      {
        const Wish& wish = wishes[w];
        gain += label[wish.a] != label[wish.b] ? -wish.weight : wish.weight;
        total += std::abs(wish.weight);
      }
      constexpr double kRounding = 1e-12;
      if (gain > kRounding * total)
      {
        label[basin] ^= 1U;
        changed = true;
      }
    }
  }
}

} // namespace

std::vector<std::uint8_t> signedRooms(const FlowComplex& flow, const Basins& basins,
  const std::vector<Wall>& walls, Index roomCount, Execution& execution)
{
  execution.step("sides", 0, 3);
  const std::vector<Wish> wishes = wishesOf(flow, basins, walls, execution);
  execution.step("sides", 1, 3);
  std::vector<std::uint8_t> label = grant(wishes, roomCount);
  execution.step("sides", 2, 3);
  flipBasins(wishes, label);
  execution.step("sides", 3, 3);
  return label;
}

} // namespace scan
