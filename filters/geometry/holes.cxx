// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/holes.h"

#include "filters/geometry/half_edges.h"
#include "filters/geometry/local_plane.h"
#include "filters/geometry/triangle_measures.h"
#include "filters/geometry/union_find.h"

#include <algorithm>
#include <numbers>

namespace scan
{
namespace
{

/// The boundary half-edges of a mesh, and which follows which.
class Boundary
{
public:
  Boundary(const TriMesh& mesh, const EdgePairs& pairs);

  /// All chains: open ones first.
  std::vector<BoundaryLoop> loops();

private:
  Index following(Index half) const;
  std::vector<Index> chainFrom(Index half);
  void addLoop(std::vector<Index> halves, bool isClosed, std::vector<BoundaryLoop>& loops) const;
  void addSimpleLoops(const std::vector<Index>& cycle, std::vector<BoundaryLoop>& loops);

  const TriMesh& Mesh;
  const EdgePairs& Pairs;
  std::vector<std::uint8_t> IsCut;  // per half-edge: of an edge that is no manifold
  std::vector<Index> Halves;        // on the boundary
  std::vector<Index> Next;          // per half-edge, kNone where the chain ends
  std::vector<std::uint8_t> IsDone; // per half-edge
  std::vector<Index> PlaceOf;       // per point: its place in the chain that is being parted
};

Boundary::Boundary(const TriMesh& mesh, const EdgePairs& pairs)
  : Mesh(mesh)
  , Pairs(pairs)
  , IsCut(oddHalves(pairs))
  , Next(pairs.mate.size(), kNone)
  , IsDone(pairs.mate.size(), 0)
  , PlaceOf(mesh.points.size(), kNone)
{
  for (Index half = 0; half < pairs.mate.size(); ++half)
  {
    if (pairs.mate[half] == kNone && this->IsCut[half] == 0 &&
      !isCollapsed(mesh.triangles[half / 3]))
    {
      this->Halves.push_back(half);
      this->Next[half] = this->following(half);
    }
  }
}

/// Turns inside the surface around the end of a boundary edge, to the next one.
Index Boundary::following(Index half) const
{
  Index turn = nextHalf(half);
  while (this->IsCut[turn] == 0)
  {
    if (this->Pairs.mate[turn] == kNone)
    {
      return turn;
    }
    turn = nextHalf(this->Pairs.mate[turn]);
  }
  return kNone;
}

std::vector<Index> Boundary::chainFrom(Index half)
{
  std::vector<Index> chain;
  while (half != kNone && this->IsDone[half] == 0)
  {
    this->IsDone[half] = 1;
    chain.push_back(half);
    half = this->Next[half];
  }
  return chain;
}

/// The length of a loop whose points have moved some times to the middle of their neighbours.
double outlineOf(const TriMesh& mesh, const std::vector<Index>& points)
{
  const std::size_t count = points.size();
  std::vector<Vec3> at(count);
  std::ranges::transform(points, at.begin(), [&](Index point) { return mesh.points[point]; });
  std::vector<Vec3> smooth(count);
  constexpr std::size_t kRounds = 8;
  for (std::size_t round = 0; round < std::min(kRounds, count / 8); ++round)
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      smooth[i] = at[i] * 0.5 + (at[(i + 1) % count] + at[(i + count - 1) % count]) * 0.25;
    }
    at.swap(smooth);
  }
  double sum = 0.0;
  for (std::size_t i = 0; i < count; ++i)
  {
    sum += scan::length(at[(i + 1) % count] - at[i]);
  }
  return sum;
}

void Boundary::addLoop(
  std::vector<Index> halves, bool isClosed, std::vector<BoundaryLoop>& loops) const
{
  if (isClosed)
  {
    std::rotate(halves.begin(), std::ranges::min_element(halves), halves.end());
  }
  BoundaryLoop loop;
  loop.isManifold = isClosed && halves.size() >= 3;
  Vec3 sum;
  for (const Index half : halves)
  {
    const Vec3& from = this->Mesh.points[originOf(this->Mesh, half)];
    const Vec3& to = this->Mesh.points[originOf(this->Mesh, nextHalf(half))];
    const double edge = scan::length(to - from);
    loop.points.push_back(originOf(this->Mesh, half));
    loop.length += edge;
    sum = sum + (from + to) * (0.5 * edge);
  }
  loop.place =
    loop.length > 0.0 ? sum * (1.0 / loop.length) : this->Mesh.points[loop.points.front()];
  loop.outline = isClosed ? outlineOf(this->Mesh, loop.points) : loop.length;
  loop.halves = std::move(halves);
  loops.push_back(std::move(loop));
}

/// Walks along and cuts off a loop wherever a point comes again.
void Boundary::addSimpleLoops(const std::vector<Index>& cycle, std::vector<BoundaryLoop>& loops)
{
  std::vector<Index> open;
  for (const Index half : cycle)
  {
    const Index from = originOf(this->Mesh, half);
    const Index before = this->PlaceOf[from];
    if (before != kNone)
    {
      const auto begin = open.begin() + static_cast<std::ptrdiff_t>(before);
      for (auto it = begin; it != open.end(); ++it)
      {
        this->PlaceOf[originOf(this->Mesh, *it)] = kNone;
      }
      this->addLoop({ begin, open.end() }, true, loops);
      open.erase(begin, open.end());
    }
    this->PlaceOf[from] = static_cast<Index>(open.size());
    open.push_back(half);
  }
  for (const Index half : open)
  {
    this->PlaceOf[originOf(this->Mesh, half)] = kNone;
  }
  this->addLoop(std::move(open), true, loops);
}

std::vector<BoundaryLoop> Boundary::loops()
{
  std::vector<std::uint8_t> isFollower(this->Next.size(), 0);
  for (const Index half : this->Halves)
  {
    if (this->Next[half] != kNone)
    {
      isFollower[this->Next[half]] = 1;
    }
  }
  std::vector<BoundaryLoop> loops;
  for (const Index half : this->Halves)
  {
    if (isFollower[half] == 0)
    {
      this->addLoop(this->chainFrom(half), false, loops);
    }
  }
  for (const Index half : this->Halves)
  {
    if (this->IsDone[half] == 0)
    {
      this->addSimpleLoops(this->chainFrom(half), loops);
    }
  }
  std::ranges::sort(
    loops, {}, [](const BoundaryLoop& loop) { return *std::ranges::min_element(loop.halves); });
  return loops;
}

void measurePieces(const TriMesh& mesh, const EdgePairs& pairs, std::vector<BoundaryLoop>& loops)
{
  UnionFind pieces(mesh.triangles.size());
  for (Index half = 0; half < pairs.mate.size(); ++half)
  {
    if (pairs.mate[half] != kNone)
    {
      pieces.unite(half / 3, pairs.mate[half] / 3);
    }
  }
  std::vector<double> area(mesh.triangles.size(), 0.0);
  for (Index t = 0; t < mesh.triangles.size(); ++t)
  {
    area[pieces.root(t)] += areaOf(mesh.points, mesh.triangles[t]);
  }
  std::vector<Index> longest(mesh.triangles.size(), kNone);
  for (Index i = 0; i < loops.size(); ++i)
  {
    const Index piece = pieces.root(loops[i].halves.front() / 3);
    loops[i].pieceArea = area[piece];
    if (longest[piece] == kNone || loops[longest[piece]].length < loops[i].length)
    {
      longest[piece] = i;
    }
  }
  for (BoundaryLoop& loop : loops)
  {
    loop.isLongest = &loops[longest[pieces.root(loop.halves.front() / 3)]] == &loop;
  }
}

} // namespace

std::vector<BoundaryLoop> boundaryLoops(const TriMesh& mesh, Execution& execution)
{
  const EdgePairs pairs = pairEdges(mesh, execution);
  std::vector<BoundaryLoop> loops = Boundary(mesh, pairs).loops();
  if (!loops.empty())
  {
    measurePieces(mesh, pairs, loops);
  }
  return loops;
}

bool isOuterRim(const BoundaryLoop& loop)
{
  return loop.isLongest && loop.outline * loop.outline > 2.0 * std::numbers::pi * loop.pieceArea;
}

} // namespace scan
