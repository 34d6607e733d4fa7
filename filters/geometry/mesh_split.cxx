// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/mesh_split.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <span>
#include <tuple>
#include <utility>

namespace scan
{
namespace
{

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

/// A triangle at a crowded edge, placed by the angle of its third corner around the edge.
struct Wing
{
  Index half;
  bool forward; // runs from the smaller end of the edge to the larger
  Kernel::Point_3 apex;
  int sector; // 0: angle 0, 1: below a half turn, 2: a half turn, 3: above, 4: on the axis
};

/// One or two triangles at a crowded edge that stay together.
struct Sheet
{
  Index forward = kNone;
  Index backward = kNone;

  Index any() const { return this->forward != kNone ? this->forward : this->backward; }
};

class Splitter
{
public:
  Splitter(TriMesh mesh, EdgePairs pairs, Execution& execution)
    : Run(execution)
    , Pairs(std::move(pairs))
    , Twin(std::move(Pairs.mate))
  {
    this->Result.mesh = std::move(mesh);
  }

  SplitResult run();

private:
  void cutMisoriented();
  std::vector<Wing> turnAround(std::span<const Index> halves) const;
  void matchSheets(std::span<const Index> halves);
  std::vector<std::uint8_t> pinchedPoints();
  void separateFans();
  void separateSheets(std::span<const Index> halves);
  void join(Index forward, Index backward);
  Index copyPoint(Index point);
  template <typename Visit>
  void forFan(Index half, Visit&& visit) const;

  std::span<const Index> crowded(std::size_t edge) const
  {
    return std::span(this->Pairs.crowded)
      .subspan(this->Pairs.crowdedBegin[edge],
        this->Pairs.crowdedBegin[edge + 1] - this->Pairs.crowdedBegin[edge]);
  }
  Index& corner(Index half) { return this->Result.mesh.triangles[half / 3][half % 3]; }
  /// The input point where a half-edge begins.
  Index originOf(Index half) const
  {
    return this->Result.pointOrigin[this->Result.mesh.triangles[half / 3][half % 3]];
  }
  bool runsForward(Index half) const
  {
    return this->originOf(half) < this->originOf(nextHalf(half));
  }

  Execution& Run;
  EdgePairs Pairs;
  std::vector<Index> Twin; // per half-edge: its reverse in the same sheet
  std::vector<bool> HasCopy;
  SplitResult Result;
};

/// Calls visit(half) for every half-edge that leaves the same corner of the same fan as `half`.
template <typename Visit>
void Splitter::forFan(Index half, Visit&& visit) const
{
  Index turn = half;
  do
  {
    visit(turn);
    turn = this->Twin[previousHalf(turn)];
  } while (turn != half && turn != kNone);
  if (turn == kNone)
  {
    for (turn = this->Twin[half]; turn != kNone; turn = this->Twin[turn])
    {
      turn = nextHalf(turn);
      visit(turn);
    }
  }
}

void Splitter::cutMisoriented()
{
  for (const Index half : this->Pairs.misoriented)
  {
    this->Twin[this->Twin[half]] = kNone;
    this->Twin[half] = kNone;
  }
  this->Result.edgesSplit += static_cast<Index>(this->Pairs.misoriented.size());
}

/// The triangles at one edge in counter-clockwise order seen against the edge's direction.
std::vector<Wing> Splitter::turnAround(std::span<const Index> halves) const
{
  const auto at = [&](Index point)
  {
    const Vec3& p = this->Result.mesh.points[point];
    return Kernel::Point_3(p.x, p.y, p.z);
  };
  const auto ends = std::minmax({ this->originOf(halves[0]), this->originOf(nextHalf(halves[0])) });
  const Kernel::Point_3 low = at(ends.first);
  const Kernel::Point_3 high = at(ends.second);

  std::vector<Wing> wings;
  const Wing* zero = nullptr;
  wings.reserve(halves.size());
  for (const Index half : halves)
  {
    Wing wing{ half, this->runsForward(half), at(this->originOf(previousHalf(half))), 0 };
    if (CGAL::collinear(low, high, wing.apex))
    {
      wing.sector = 4;
    }
    else if (zero)
    {
      const CGAL::Orientation side = CGAL::orientation(low, high, zero->apex, wing.apex);
      const bool opposite = side == CGAL::COPLANAR &&
        CGAL::coplanar_orientation(low, high, zero->apex, wing.apex) == CGAL::NEGATIVE;
      wing.sector = side == CGAL::POSITIVE ? 1 : side == CGAL::NEGATIVE ? 3 : opposite ? 2 : 0;
    }
    wings.push_back(wing);
    zero = !zero && wing.sector == 0 ? &wings.back() : zero;
  }
  std::sort(wings.begin(), wings.end(),
    [&](const Wing& a, const Wing& b)
    {
      if (a.sector == b.sector && (a.sector == 1 || a.sector == 3))
      {
        const CGAL::Orientation turn = CGAL::orientation(low, high, a.apex, b.apex);
        if (turn != CGAL::COPLANAR)
        {
          return turn == CGAL::POSITIVE;
        }
      }
      // coincident triangles: one solid ends before the next begins
      return std::tuple(a.sector, !a.forward, a.half) < std::tuple(b.sector, !b.forward, b.half);
    });
  return wings;
}

void Splitter::join(Index forward, Index backward)
{
  for (const auto& [half, twin] : { std::pair(forward, backward), std::pair(backward, forward) })
  {
    if (half != kNone)
    {
      this->Twin[half] = twin;
    }
  }
}

/// Turning counter-clockwise, a backward triangle enters a solid and a forward one leaves it:
/// they match like brackets, so no two sheets cross.
void Splitter::matchSheets(std::span<const Index> halves)
{
  std::vector<Index> entered;
  std::vector<Index> leftOver;
  for (const Wing& wing : this->turnAround(halves))
  {
    if (!wing.forward)
    {
      entered.push_back(wing.half);
    }
    else if (entered.empty())
    {
      leftOver.push_back(wing.half);
    }
    else
    {
      this->join(wing.half, entered.back());
      entered.pop_back();
    }
  }
  for (const Index forward : leftOver) // solids across the angle where the turn began
  {
    if (entered.empty())
    {
      return;
    }
    this->join(forward, entered.back());
    entered.pop_back();
  }
}

Index Splitter::copyPoint(Index point)
{
  const Index origin = this->Result.pointOrigin[point];
  if (!this->HasCopy[origin])
  {
    this->HasCopy[origin] = true;
    ++this->Result.verticesSplit;
  }
  TriMesh& mesh = this->Result.mesh;
  mesh.points.push_back(Vec3(mesh.points[origin]));
  this->Result.pointOrigin.push_back(origin);
  return static_cast<Index>(mesh.points.size() - 1);
}

/// The points with several fans.
std::vector<std::uint8_t> Splitter::pinchedPoints()
{
  const std::size_t pointCount = this->Result.mesh.points.size();
  std::vector<Index> first(pointCount, kNone); // half-edge
  std::vector<Index> halves(pointCount, 0);
  std::vector<std::uint8_t> isPinched(pointCount, 0);
  for (Index half = 0; half < this->Twin.size(); ++half)
  {
    const Index point = this->corner(half);
    first[point] = halves[point]++ == 0 ? half : first[point];
  }
  this->Run.parallelFor(pointCount, 1 << 13,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t point = begin; point < end; ++point)
      {
        Index inFan = 0;
        if (first[point] != kNone)
        {
          this->forFan(first[point], [&](Index) { ++inFan; });
        }
        isPinched[point] = inFan != halves[point] ? 1 : 0;
      }
    });
  return isPinched;
}

/// Gives every fan its own point: the first keeps the input point, others get copies.
void Splitter::separateFans()
{
  const std::vector<std::uint8_t> isPinched = this->pinchedPoints();
  std::vector<bool> visited(this->Twin.size());
  std::vector<bool> taken(isPinched.size());
  for (Index half = 0; half < this->Twin.size(); ++half)
  {
    const Index point = this->originOf(half);
    if (isPinched[point] == 0 || visited[half])
    {
      continue;
    }
    const Index own = taken[point] ? this->copyPoint(point) : point;
    taken[point] = true;
    this->forFan(half,
      [&](Index turn)
      {
        visited[turn] = true;
        this->corner(turn) = own;
      });
  }
}

/// Sheets of one edge that share the points at both ends lie in one fan at either end. Swapping
/// their partners breaks both fans in two, so each swap makes two points and this ends.
void Splitter::separateSheets(std::span<const Index> halves)
{
  std::vector<Sheet> sheets;
  for (const Index half : halves)
  {
    if (this->runsForward(half))
    {
      sheets.push_back({ half, this->Twin[half] });
    }
    else if (this->Twin[half] == kNone)
    {
      sheets.push_back({ kNone, half });
    }
  }
  const auto ends = [&](const Sheet& sheet)
  {
    const Index half = sheet.any();
    return std::minmax({ this->corner(half), this->corner(nextHalf(half)) });
  };
  const auto byEnds = [&](const Sheet& a, const Sheet& b) { return ends(a) < ends(b); };
  for (bool changed = true; changed;)
  {
    changed = false;
    std::stable_sort(sheets.begin(), sheets.end(), byEnds);
    for (std::size_t i = 1; i < sheets.size(); ++i)
    {
      Sheet& one = sheets[i - 1];
      Sheet& other = sheets[i];
      if (ends(one) != ends(other))
      {
        continue;
      }
      changed = true;
      std::swap(one.backward, other.backward);
      this->join(one.forward, one.backward);
      this->join(other.forward, other.backward);
      for (const Index half : { one.any(), nextHalf(one.any()) })
      {
        const Index own = this->copyPoint(this->corner(half));
        this->forFan(half, [&](Index turn) { this->corner(turn) = own; });
      }
    }
  }
}

SplitResult Splitter::run()
{
  const std::size_t pointCount = this->Result.mesh.points.size();
  const std::size_t crowdedEdges = this->Pairs.crowdedBegin.size() - 1;
  this->Result.pointOrigin.resize(pointCount);
  std::iota(this->Result.pointOrigin.begin(), this->Result.pointOrigin.end(), Index{ 0 });
  this->Result.edgesSplit = static_cast<Index>(crowdedEdges);
  this->HasCopy.assign(pointCount, false);

  this->cutMisoriented();
  for (std::size_t edge = 0; edge < crowdedEdges; ++edge)
  {
    this->matchSheets(this->crowded(edge));
  }
  this->separateFans();
  for (std::size_t edge = 0; edge < crowdedEdges; ++edge)
  {
    this->separateSheets(this->crowded(edge));
  }
  this->Result.mate = std::move(this->Twin);
  return std::move(this->Result);
}

} // namespace

SplitResult splitNonManifold(TriMesh mesh, Execution& execution)
{
  EdgePairs pairs = pairEdges(mesh, execution);
  return splitNonManifold(std::move(mesh), std::move(pairs), execution);
}

SplitResult splitNonManifold(TriMesh mesh, EdgePairs pairs, Execution& execution)
{
  return Splitter(std::move(mesh), std::move(pairs), execution).run();
}

} // namespace scan
