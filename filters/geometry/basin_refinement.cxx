// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/basin_refinement.h"

#include "filters/geometry/cut_cover.h"
#include "filters/geometry/facet_radius.h"
#include "filters/geometry/incidence.h"
#include "filters/geometry/triangle_size.h"
#include "filters/geometry/union_find.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

namespace scan
{
namespace
{

constexpr std::array kLevels{ 3.0F, 2.0F, 1.5F, 1.25F, 1.1F, 1.03F, 1.0F };
constexpr float kSingleBasins = 0.0F; // a level that joins nothing
constexpr std::array kExcessWeights{ 0.02, 0.1 };
constexpr int kPasses = 6; // per level
constexpr double kLeastGain = 1e-9;

/// A wall with what the objective asks about it.
struct MeasuredWall
{
  Triangle vertices;
  Index a;
  Index b; ///< numbers after the last basin stand for rooms of the outside
  float excess;
  float doorRatio; ///< smaller of the two sizes / radius of the triangle; infinite on the hull
};

std::vector<MeasuredWall> measure(const FlowComplex& flow, const Basins& basins,
  const std::vector<Wall>& walls, const std::vector<float>& spacing, Execution& execution)
{
  const DelaunayComplex& complex = flow.delaunay();
  std::vector<MeasuredWall> measured(walls.size());
  execution.parallelFor(walls.size(), 1 << 14,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t w = begin; w < end; ++w)
      {
        const auto& [facet, a, b] = walls[w];
        const Triangle v = complex.facetVertices(facet);
        float doorRatio = std::numeric_limits<float>::infinity();
        if (b < basins.count())
        {
          doorRatio = static_cast<float>(
            std::min(basins.size[a], basins.size[b]) / std::sqrt(facetRadiusSquared(flow, facet)));
        }
        measured[w] = { v, a, b, static_cast<float>(TriangleSize(complex, spacing, v).excess()),
          doorRatio };
      }
    });
  return measured;
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

/// What is known about the cut beside a basin or group without trying to flip it.
struct Census
{
  int cutTriangles = 0;
  int uncutBorder = 0; ///< walls to other groups that would become cut
  int ownPoints = 0;   ///< points all of whose cut triangles are here
  double cutExcess = 0.0;

  /// No flip gains more: each border triangle covers or saves at most three points, and the points
  /// owned and not saved are lost.
  double mostGain(double excessWeight) const
  {
    return 2.0 * (3.0 * this->uncutBorder - this->ownPoints) -
      0.5 * (this->uncutBorder - this->cutTriangles) + excessWeight * this->cutExcess;
  }
};

class BasinRefinement
{
public:
  BasinRefinement(const Basins& basins, std::vector<MeasuredWall> walls, std::size_t pointCount,
    FinestGroups finest, std::vector<std::uint8_t> inside, Execution& execution)
    : Sizes(basins.size)
    , BasinCount(basins.count())
    , RoomCount(static_cast<Index>(inside.size()))
    , FlipCount(finest == FinestGroups::singleBasins ? RoomCount : BasinCount)
    , Walls(std::move(walls))
    , Inside(std::move(inside))
    , Cover(pointCount)
    , Touched(RoomCount, 0)
    , Trials(RoomCount)
    , Group(RoomCount)
  {
    const std::array<std::function<void()>, 3> parts{ [&] { this->fileByPoint(); },
      [&] { this->fileByBasin(); },
      [&]
      {
        this->countCover();
        this->takeCensus();
      } };
    execution.parallelFor(parts.size(), 1,
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t i = begin; i < end; ++i)
        {
          parts[i]();
        }
      });
  }

  /// One sweep at one level; returns whether anything flipped.
  bool sweep(float level, double excessWeight)
  {
    if (this->LastFlip > this->CensusTime)
    {
      this->takeCensus();
    }
    this->formGroups(level);
    bool flipped = false;
    for (const Index group : this->GroupsBySize)
    {
      flipped |= this->tryGroup(group, excessWeight);
    }
    return flipped;
  }

  std::vector<std::uint8_t> takeLabels() { return std::move(this->Inside); }

private:
  /// A group that was tried in vain: when neither its members nor anything around it changed
  /// since, the answer still holds.
  struct Trial
  {
    std::uint64_t members = 0; ///< hash of the set of basins
    std::uint32_t time = 0;
    Change change;
  };

  bool isCut(const MeasuredWall& wall) const
  {
    return this->Inside[wall.a] != this->Inside[wall.b];
  }

  void fileByPoint()
  {
    this->WallsOfPoint = Incidence(this->Cover.pointCount(), this->Walls.size(),
      [&](std::size_t w, auto&& visit)
      { std::for_each(this->Walls[w].vertices.begin(), this->Walls[w].vertices.end(), visit); });
  }

  void fileByBasin()
  {
    this->WallsOfBasin = Incidence(this->RoomCount, this->Walls.size(),
      [&](std::size_t w, auto&& visit)
      {
        visit(this->Walls[w].a);
        visit(this->Walls[w].b);
      });
  }

  void countCover()
  {
    for (const MeasuredWall& wall : this->Walls)
    {
      if (this->isCut(wall))
      {
        this->Cover.count(wall.vertices, +1);
      }
    }
  }

  /// Per basin: its share of the cut and the points it owns.
  void takeCensus()
  {
    this->CensusTime = ++this->Clock;
    this->CensusOfBasin.assign(this->RoomCount, {});
    this->UncutWalls.clear();
    // of all basins at a point's cut triangles, the at most two that are at every one of them
    std::vector<std::array<Index, 2>> owners(this->Cover.pointCount(), { kNone, kNone });
    std::vector<std::uint8_t> seen(this->Cover.pointCount(), 0);
    for (Index w = 0; w < this->Walls.size(); ++w)
    {
      const MeasuredWall& wall = this->Walls[w];
      if (!this->isCut(wall))
      {
        this->UncutWalls.push_back(w);
        continue;
      }
      for (const Index basin : { wall.a, wall.b })
      {
        ++this->CensusOfBasin[basin].cutTriangles;
        this->CensusOfBasin[basin].cutExcess += static_cast<double>(wall.excess);
      }
      for (const Index v : wall.vertices)
      {
        if (!seen[v])
        {
          seen[v] = 1;
          owners[v] = { wall.a, wall.b };
          continue;
        }
        for (Index& owner : owners[v])
        {
          owner = owner == wall.a || owner == wall.b ? owner : kNone;
        }
      }
    }
    for (const auto& pair : owners)
    {
      for (const Index owner : pair)
      {
        if (owner != kNone)
        {
          ++this->CensusOfBasin[owner].ownPoints;
        }
      }
    }
  }

  /// Joins basins of equal label; a group is named by its first basin.
  void formGroups(float level)
  {
    UnionFind sets(this->RoomCount);
    for (const Index w : this->UncutWalls)
    {
      const MeasuredWall& wall = this->Walls[w];
      if (wall.doorRatio <= level)
      {
        sets.unite(wall.a, wall.b);
      }
    }
    for (Index basin = 0; basin < this->RoomCount; ++basin)
    {
      this->Group[basin] = sets.root(basin);
    }
    this->Members = Incidence(this->RoomCount, this->FlipCount,
      [&](std::size_t basin, auto&& visit) { visit(this->Group[basin]); });
    this->CensusOfGroup.assign(this->RoomCount, {});
    std::vector<double> size(this->RoomCount, 0.0);
    this->GroupsBySize.clear();
    for (Index basin = 0; basin < this->FlipCount; ++basin)
    {
      const Index group = this->Group[basin];
      const Census& own = this->CensusOfBasin[basin];
      Census& sum = this->CensusOfGroup[group];
      sum.cutTriangles += own.cutTriangles;
      sum.cutExcess += own.cutExcess;
      sum.ownPoints += own.ownPoints;
      size[group] = std::max(size[group],
        (basin < this->BasinCount ? this->Sizes[basin] : std::numeric_limits<double>::infinity()));
      if (group == basin)
      {
        this->GroupsBySize.push_back(group);
      }
    }
    for (const Index w : this->UncutWalls)
    {
      const Index a = this->Group[this->Walls[w].a];
      const Index b = this->Group[this->Walls[w].b];
      this->CensusOfGroup[a].uncutBorder += a != b ? 1 : 0;
      this->CensusOfGroup[b].uncutBorder += a != b ? 1 : 0;
    }
    std::stable_sort(this->GroupsBySize.begin(), this->GroupsBySize.end(),
      [&](Index p, Index q) { return size[p] > size[q]; });
  }

  bool tryGroup(Index group, double excessWeight)
  {
    std::uint64_t hash = 0;
    std::uint32_t touched = 0;
    for (const Index basin : this->Members.of(group))
    {
      hash += (basin + 1) * 0x9E3779B97F4A7C15ULL ^ (std::uint64_t{ basin } << 32);
      touched = std::max(touched, this->Touched[basin]);
    }
    Trial& trial = this->Trials[group];
    const bool isKnown = trial.time > touched && trial.members == hash;
    const bool isHopeless = touched <= this->CensusTime &&
      this->CensusOfGroup[group].mostGain(excessWeight) <= kLeastGain;
    if (isHopeless || (isKnown && trial.change.gain(excessWeight) <= kLeastGain))
    {
      return false;
    }
    const Change change = this->flip(group);
    if (change.gain(excessWeight) <= kLeastGain)
    {
      this->flip(group);
      trial = { hash, ++this->Clock, change };
      return false;
    }
    this->LastFlip = ++this->Clock;
    this->touchSurroundings(group);
    return true;
  }

  /// Calls visit(wall) for the walls between the group and the rest.
  template <class Visit>
  void forEachBorderWall(Index group, Visit&& visit)
  {
    for (const Index basin : this->Members.of(group))
    {
      for (const Index w : this->WallsOfBasin.of(basin))
      {
        const MeasuredWall& wall = this->Walls[w];
        if (this->Group[wall.a] != this->Group[wall.b])
        {
          visit(wall);
        }
      }
    }
  }

  Change flip(Index group)
  {
    for (const Index basin : this->Members.of(group))
    {
      this->Inside[basin] ^= 1U;
    }
    Change change;
    this->forEachBorderWall(group,
      [&](const MeasuredWall& wall)
      {
        const int sign = this->isCut(wall) ? +1 : -1;
        change.points += this->Cover.count(wall.vertices, sign);
        change.triangles += sign;
        change.excess += sign * static_cast<double>(wall.excess);
      });
    return change;
  }

  /// Everything at a point whose count changed may now answer differently.
  void touchSurroundings(Index group)
  {
    this->forEachBorderWall(group,
      [&](const MeasuredWall& wall)
      {
        for (const Index v : wall.vertices)
        {
          for (const Index around : this->WallsOfPoint.of(v))
          {
            this->Touched[this->Walls[around].a] = this->LastFlip;
            this->Touched[this->Walls[around].b] = this->LastFlip;
          }
        }
      });
  }

  const std::vector<double>& Sizes;
  Index BasinCount;
  Index RoomCount; ///< basins and rooms of the outside
  Index FlipCount; ///< those that may flip
  std::vector<MeasuredWall> Walls;
  std::vector<std::uint8_t> Inside;
  CutCover Cover;
  Incidence WallsOfBasin;
  Incidence WallsOfPoint;

  std::uint32_t Clock = 0;
  std::uint32_t LastFlip = 0;
  std::uint32_t CensusTime = 0;
  std::vector<std::uint32_t> Touched; ///< per basin: when something around it last changed
  std::vector<Trial> Trials;          ///< per group, by its name

  std::vector<Census> CensusOfBasin;
  std::vector<Index> UncutWalls;

  // the groups of the sweep
  std::vector<Index> Group; ///< per basin
  Incidence Members;
  std::vector<Census> CensusOfGroup;
  std::vector<Index> GroupsBySize;
};

} // namespace

std::vector<std::uint8_t> refineBasins(const FlowComplex& flow, const Basins& basins,
  const std::vector<Wall>& walls, const std::vector<float>& spacing, FinestGroups finest,
  std::vector<std::uint8_t> inside, Execution& execution)
{
  execution.step("refine", 0, 1);
  BasinRefinement refinement(basins, measure(flow, basins, walls, spacing, execution),
    flow.delaunay().points.size(), finest, std::move(inside), execution);
  std::vector<float> levels(kLevels.begin(), kLevels.end());
  if (finest == FinestGroups::singleBasins)
  {
    levels.push_back(kSingleBasins);
  }
  const std::size_t steps = kExcessWeights.size() * levels.size() + 1;
  std::size_t step = 0;
  for (const double excessWeight : kExcessWeights)
  {
    for (const float level : levels)
    {
      execution.step("refine", ++step, steps);
      int pass = 0;
      while (pass < kPasses && refinement.sweep(level, excessWeight))
      {
        execution.step("refine", step, steps);
        ++pass;
      }
    }
  }
  return refinement.takeLabels();
}

} // namespace scan
