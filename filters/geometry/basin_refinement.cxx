// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/cut_refinement.h"

#include "filters/geometry/scan_spacing.h"
#include "filters/geometry/union_find.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace scan
{
namespace
{

constexpr std::array kLevels{ 3.0F, 2.0F, 1.5F, 1.25F, 1.1F, 1.03F, 1.0F };
constexpr std::array kExcessWeights{ 0.02, 0.1 };
constexpr int kPasses = 6; // per level

/// A triangle between two basins, or between a basin and the outside of the hull.
struct Wall
{
  Triangle vertices;
  Index a;
  Index b; ///< the outside is the number after the last basin
  float excess;
  float doorRatio; ///< smaller of the two sizes / radius of the triangle; infinite on the hull
};

/// For each of `count` owners the numbers of its items.
class Incidence
{
public:
  /// ownersOf(item, visit) calls visit(owner) for each owner of the item.
  template <class OwnersOf>
  Incidence(std::size_t count, std::size_t items, OwnersOf&& ownersOf)
    : First(count + 1, 0)
  {
    for (std::size_t item = 0; item < items; ++item)
    {
      ownersOf(item, [&](Index owner) { ++this->First[owner]; });
    }
    std::partial_sum(this->First.begin(), this->First.end(), this->First.begin());
    this->Items.resize(this->First.back());
    for (std::size_t item = 0; item < items; ++item)
    {
      ownersOf(
        item, [&](Index owner) { this->Items[--this->First[owner]] = static_cast<Index>(item); });
    }
  }

  std::span<const Index> of(Index owner) const
  {
    return { this->Items.data() + this->First[owner], this->Items.data() + this->First[owner + 1] };
  }

private:
  std::vector<Index> First;
  std::vector<Index> Items;
};

std::vector<Wall> findWalls(
  const FlowComplex& flow, const Basins& basins, const std::vector<float>& spacing)
{
  const DelaunayComplex& complex = flow.delaunay();
  std::vector<Wall> walls;
  for (Facet facet = 0; facet < 4 * complex.tetCount(); ++facet)
  {
    const Index beyond = complex.neighbour(facet / 4, static_cast<int>(facet % 4));
    const Index a = basins.ofTet[facet / 4];
    const Index b = beyond == kNone ? basins.count() : basins.ofTet[beyond];
    if (a == b || complex.canonical(facet) != facet)
    {
      continue;
    }
    const Triangle v = complex.facetVertices(facet);
    float doorRatio = std::numeric_limits<float>::infinity();
    if (beyond != kNone)
    {
      // the radius function: an attached facet has the radius of its tetrahedron
      const double radius2 = flow.isAttached(facet) ? circumradiusSquared(complex, facet / 4)
        : flow.isFree(facet)                        ? circumradiusSquared(complex, v)
                                                    : circumradiusSquared(complex, beyond);
      doorRatio = static_cast<float>(std::min(basins.size[a], basins.size[b]) / std::sqrt(radius2));
    }
    walls.push_back({ v, a, b, excessArea(complex, spacing, v), doorRatio });
  }
  return walls;
}

/// What flipping a group would change.
struct Change
{
  int points = 0;
  int triangles = 0;
  double excess = 0.0;

  double gain(double excessWeight) const
  {
    return 2.0 * this->points - 0.5 * this->triangles - excessWeight * this->excess;
  }
};

class BasinRefinement
{
public:
  BasinRefinement(const Basins& basins, std::vector<Wall> walls, std::size_t pointCount,
    std::vector<std::uint8_t> inside)
    : Sizes(basins.size)
    , BasinCount(basins.count())
    , Walls(std::move(walls))
    , WallsOfBasin(BasinCount + 1, Walls.size(),
        [&](std::size_t w, auto&& visit)
        {
          visit(this->Walls[w].a);
          visit(this->Walls[w].b);
        })
    , WallsOfPoint(pointCount, Walls.size(),
        [&](std::size_t w, auto&& visit)
        { std::for_each(this->Walls[w].vertices.begin(), this->Walls[w].vertices.end(), visit); })
    , Inside(std::move(inside))
    , CutTriangles(pointCount, 0)
    , Touched(BasinCount + 1, 0)
    , Trials(BasinCount)
    , Group(BasinCount + 1)
  {
    this->Inside.push_back(0); // outside the hull
    for (const Wall& wall : this->Walls)
    {
      this->count(wall, +1 * (this->Inside[wall.a] != this->Inside[wall.b]));
    }
  }

  /// One sweep at one level; returns whether anything flipped.
  bool sweep(float level, double excessWeight)
  {
    this->formGroups(level);
    bool flipped = false;
    for (const Index group : this->GroupsBySize)
    {
      flipped |= this->tryGroup(group, excessWeight);
    }
    return flipped;
  }

  std::vector<std::uint8_t> takeLabels()
  {
    this->Inside.pop_back();
    return std::move(this->Inside);
  }

private:
  /// A group that was tried in vain: when neither its members nor anything around it changed
  /// since, the answer still holds.
  struct Trial
  {
    std::uint64_t members = 0; ///< hash of the set of basins
    std::uint32_t time = 0;
    Change change;
  };

  /// Joins basins of equal label; a group is named by its first basin.
  void formGroups(float level)
  {
    UnionFind sets(this->BasinCount);
    for (const Wall& wall : this->Walls)
    {
      if (wall.doorRatio <= level && this->Inside[wall.a] == this->Inside[wall.b])
      {
        const Index a = sets.root(wall.a);
        const Index b = sets.root(wall.b);
        sets.join(std::min(a, b), std::max(a, b));
      }
    }
    this->GroupsBySize.clear();
    this->Members.assign(this->BasinCount, {});
    std::vector<double> size(this->BasinCount, 0.0);
    for (Index basin = 0; basin < this->BasinCount; ++basin)
    {
      const Index group = sets.root(basin);
      this->Group[basin] = group;
      this->Members[group].push_back(basin);
      size[group] = std::max(size[group], this->Sizes[basin]);
      if (group == basin)
      {
        this->GroupsBySize.push_back(group);
      }
    }
    this->Group[this->BasinCount] = kNone;
    std::stable_sort(this->GroupsBySize.begin(), this->GroupsBySize.end(),
      [&](Index p, Index q) { return size[p] > size[q]; });
  }

  bool tryGroup(Index group, double excessWeight)
  {
    constexpr double kLeastGain = 1e-9;
    const std::vector<Index>& members = this->Members[group];
    std::uint64_t hash = 0;
    std::uint32_t touched = 0;
    for (const Index basin : members)
    {
      hash += (basin + 1) * 0x9E3779B97F4A7C15ULL ^ (std::uint64_t{ basin } << 32);
      touched = std::max(touched, this->Touched[basin]);
    }
    Trial& trial = this->Trials[group];
    const bool known = trial.time > touched && trial.members == hash;
    if (known && trial.change.gain(excessWeight) <= kLeastGain)
    {
      return false;
    }
    const Change change = this->flip(members);
    if (change.gain(excessWeight) <= kLeastGain)
    {
      this->flip(members);
      trial = { hash, ++this->Clock, change };
      return false;
    }
    this->touchSurroundings(members);
    return true;
  }

  Change flip(const std::vector<Index>& members)
  {
    Change change;
    for (const Index basin : members)
    {
      this->Inside[basin] ^= 1U;
    }
    for (const Index basin : members)
    {
      for (const Index w : this->WallsOfBasin.of(basin))
      {
        const Wall& wall = this->Walls[w];
        if (this->Group[wall.a] != this->Group[wall.b])
        {
          const int sign = this->Inside[wall.a] != this->Inside[wall.b] ? +1 : -1;
          change.points += this->count(wall, sign);
          change.triangles += sign;
          change.excess += sign * static_cast<double>(wall.excess);
        }
      }
    }
    return change;
  }

  /// Counts the wall in or out of the cut at its vertices; returns the change in covered points.
  int count(const Wall& wall, int sign)
  {
    int change = 0;
    for (const Index v : wall.vertices)
    {
      const int before = this->CutTriangles[v];
      this->CutTriangles[v] = before + sign;
      change += (before + sign > 0) - (before > 0);
    }
    return change;
  }

  /// Everything at a point whose count changed may now answer differently.
  void touchSurroundings(const std::vector<Index>& members)
  {
    ++this->Clock;
    for (const Index basin : members)
    {
      for (const Index w : this->WallsOfBasin.of(basin))
      {
        const Wall& wall = this->Walls[w];
        if (this->Group[wall.a] == this->Group[wall.b])
        {
          continue;
        }
        for (const Index v : wall.vertices)
        {
          for (const Index around : this->WallsOfPoint.of(v))
          {
            this->Touched[this->Walls[around].a] = this->Clock;
            this->Touched[this->Walls[around].b] = this->Clock;
          }
        }
      }
    }
  }

  const std::vector<double>& Sizes;
  Index BasinCount;
  std::vector<Wall> Walls;
  Incidence WallsOfBasin;
  Incidence WallsOfPoint;
  std::vector<std::uint8_t> Inside;
  std::vector<int> CutTriangles; ///< per point
  std::uint32_t Clock = 0;
  std::vector<std::uint32_t> Touched; ///< per basin: when something around it last changed
  std::vector<Trial> Trials;          ///< per group, by its name
  std::vector<Index> Group;
  std::vector<std::vector<Index>> Members;
  std::vector<Index> GroupsBySize;
};

} // namespace

std::vector<std::uint8_t> refineBasins(const FlowComplex& flow, const Basins& basins,
  const std::vector<float>& spacing, std::vector<std::uint8_t> inside, Execution& execution)
{
  execution.step("refine", 0, 1);
  BasinRefinement refinement(
    basins, findWalls(flow, basins, spacing), flow.delaunay().points.size(), std::move(inside));
  constexpr std::size_t kSteps = kExcessWeights.size() * kLevels.size() + 1;
  std::size_t step = 0;
  for (const double excessWeight : kExcessWeights)
  {
    for (const float level : kLevels)
    {
      execution.step("refine", ++step, kSteps);
      int pass = 0;
      while (pass < kPasses && refinement.sweep(level, excessWeight))
      {
        execution.step("refine", step, kSteps);
        ++pass;
      }
    }
  }
  return refinement.takeLabels();
}

} // namespace scan
