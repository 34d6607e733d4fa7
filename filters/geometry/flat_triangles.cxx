// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/flat_triangles.h"

#include "filters/geometry/half_edges.h"
#include "filters/geometry/union_find.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <queue>
#include <span>
#include <unordered_map>
#include <utility>

namespace scan
{
namespace
{

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

Kernel::Point_3 exact(const Vec3& p)
{
  return { p.x, p.y, p.z };
}

double largest(const Vec3& v)
{
  return std::max({ std::abs(v.x), std::abs(v.y), std::abs(v.z) });
}

std::uint64_t keyOf(Index a, Index b)
{
  const auto [low, high] = std::minmax(a, b);
  return std::uint64_t{ low } << 32U | high;
}

class FlatRemover
{
public:
  FlatRemover(TriMesh mesh, double leastHeight, Execution& execution)
    : Run(execution)
    , LeastHeight(leastHeight)
    , Mesh(std::move(mesh))
    , Origin(this->Mesh.triangles.size())
    , IsTouched(this->Mesh.points.size())
  {
    std::iota(this->Origin.begin(), this->Origin.end(), Index{ 0 });
  }

  FlatRemoval run()
  {
    const double least = std::exchange(this->LeastHeight, 0.0);
    this->removeExactly();
    if (least > 0.0)
    {
      this->LeastHeight = least;
      this->removeLow();
    }
    if (std::ranges::find(this->IsTouched, true) != this->IsTouched.end())
    {
      this->cancelFolds();
    }
    const Index cut = this->countCut();
    return { std::move(this->Mesh), std::move(this->Origin), cut };
  }

private:
  /// The corners of a flat triangle along its line.
  struct Line
  {
    Index start;
    Index middle;
    Index end;
  };

  /// Points of flat triangles that hang together by edges, in their order along the line.
  struct Chain
  {
    std::vector<Index> points;
    double Vec3::*axis = nullptr; // along which no two places on the line are equal
  };

  const Vec3& at(Index point) const { return this->Mesh.points[point]; }

  bool isInOnePlace(Index a, Index b) const
  {
    const Vec3 apart = this->at(b) - this->at(a);
    return dot(apart, apart) <= this->LeastHeight * this->LeastHeight &&
      (this->LeastHeight > 0.0 || this->at(a) == this->at(b)); // squares may vanish
  }

  bool hasEqualCorners(const Triangle& t) const
  {
    const auto& [a, b, c] = t;
    return this->isInOnePlace(a, b) || this->isInOnePlace(b, c) || this->isInOnePlace(c, a);
  }

  bool isFlatTriangle(const Triangle& t) const
  {
    const auto& [a, b, c] = t;
    if (this->LeastHeight == 0.0)
    {
      return isFlat(this->at(a), this->at(b), this->at(c));
    }
    const Vec3 normal = cross(this->at(b) - this->at(a), this->at(c) - this->at(a));
    const std::size_t k = this->oppositeLongest(t);
    const Vec3 along = this->at(t[(k + 2) % 3]) - this->at(t[(k + 1) % 3]);
    return dot(normal, normal) <= this->LeastHeight * this->LeastHeight * dot(along, along);
  }

  /// The corner opposite the longest edge.
  std::size_t oppositeLongest(const Triangle& t) const
  {
    const auto squared = [&](std::size_t k)
    {
      const Vec3 along = this->at(t[(k + 2) % 3]) - this->at(t[(k + 1) % 3]);
      return dot(along, along);
    };
    const std::size_t k = squared(1) > squared(0) ? 1 : 0;
    return squared(2) > squared(k) ? 2 : k;
  }

  void removeExactly();
  void removeLow();
  std::vector<Index> findFlat();
  bool mergeEqualCorners(std::span<const Index> flat);
  void mergeShortestEdges(std::span<const Index> flat);
  void mergePoints(UnionFind& sets);
  void findChains(std::span<const Index> flat);
  bool mergeInChains();
  void cutAtChains(std::span<const Index> flat);
  void appendCut(const Triangle& t, Index origin, FlatRemoval& result);
  std::vector<Index> between(Index from, Index to) const;
  void dissolve(std::span<const Index> flat);
  void dissolveOne(Index number);
  void fileEdges(Index number);
  void dropGone();
  Line lineOf(const Triangle& t) const;
  void push(Index number);
  void add(const Triangle& t, Index origin);
  void cut(Index number, const Line& line);
  void cancelFolds();
  Index countCut() const;

  Execution& Run;
  double LeastHeight;
  TriMesh Mesh;
  std::vector<Index> Origin;

  std::vector<bool> IsTouched; // per point: a corner of what was changed
  std::vector<bool> IsOnLine;  // per point: a corner of a flat triangle

  // exact: flat triangles that hang together by edges, all on one line
  std::vector<Chain> Chains;
  std::unordered_map<std::uint64_t, Index> ChainOf; // per edge of a flat triangle

  // with a tolerance
  std::vector<bool> IsGone;                             // per triangle
  std::unordered_multimap<std::uint64_t, Index> ByEdge; // triangles at edges between such points
  std::priority_queue<std::pair<double, Index>> Queue;  // flat triangles by their squared length
};

/// Nothing moves, and nothing without area comes about: what is cut has a corner off the line.
void FlatRemover::removeExactly()
{
  for (std::vector<Index> flat = this->findFlat(); !flat.empty(); flat = this->findFlat())
  {
    if (this->mergeEqualCorners(flat))
    {
      continue; // with fewer points
    }
    flat = this->findFlat(); // without those that name a point twice
    this->findChains(flat);
    if (!this->mergeInChains())
    {
      this->cutAtChains(flat);
    }
  }
}

void FlatRemover::removeLow()
{
  for (std::vector<Index> flat = this->findFlat(); !flat.empty();)
  {
    this->mergeEqualCorners(flat);
    this->dissolve(this->findFlat());
    this->dropGone();
    std::vector<Index> left = this->findFlat();
    if (left.size() > flat.size() / 2) // cuts that undo each other
    {
      this->mergeShortestEdges(left);
      left = this->findFlat();
    }
    flat = std::move(left);
  }
}

std::vector<Index> FlatRemover::findFlat()
{
  const std::vector<Triangle>& triangles = this->Mesh.triangles;
  std::vector<std::uint8_t> isFlatOne(triangles.size());
  this->Run.parallelFor(triangles.size(), std::size_t{ 1 } << 15U,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t t = begin; t < end; ++t)
      {
        isFlatOne[t] = this->isFlatTriangle(triangles[t]) ? 1 : 0;
      }
    });
  std::vector<Index> flat;
  for (Index t = 0; t < isFlatOne.size(); ++t)
  {
    if (isFlatOne[t] != 0)
    {
      flat.push_back(t);
    }
  }
  return flat;
}

/// Corners of flat triangles in one place become one point; triangles that lose a corner go.
/// @return whether there were such corners
bool FlatRemover::mergeEqualCorners(std::span<const Index> flat)
{
  UnionFind sets(this->Mesh.points.size());
  bool isMerged = false;
  for (const Index number : flat)
  {
    const Triangle t = this->Mesh.triangles[number];
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Index a = sets.root(t[k]);
      const Index b = sets.root(t[(k + 1) % 3]);
      if (a != b && this->isInOnePlace(a, b))
      {
        sets.unite(a, b);
        isMerged = true;
      }
    }
  }
  this->mergePoints(sets);
  return isMerged;
}

/// The ends of the shortest edge of each flat triangle become one point.
void FlatRemover::mergeShortestEdges(std::span<const Index> flat)
{
  UnionFind sets(this->Mesh.points.size());
  for (const Index number : flat)
  {
    const Triangle& t = this->Mesh.triangles[number];
    const auto squared = [&](std::size_t k)
    {
      const Vec3 along = this->at(t[(k + 1) % 3]) - this->at(t[k]);
      return dot(along, along);
    };
    constexpr std::array kSides = { 0U, 1U, 2U };
    const std::size_t k = *std::ranges::min_element(kSides, {}, squared);
    const Index a = sets.root(t[k]);
    const Index b = sets.root(t[(k + 1) % 3]);
    if (a != b)
    {
      sets.join(std::min(a, b), std::max(a, b));
    }
  }
  this->mergePoints(sets);
}

void FlatRemover::mergePoints(UnionFind& sets)
{
  this->IsGone.assign(this->Mesh.triangles.size(), false);
  for (std::size_t number = 0; number < this->Mesh.triangles.size(); ++number)
  {
    Triangle& t = this->Mesh.triangles[number];
    for (Index& corner : t)
    {
      const Index root = sets.root(corner);
      this->IsTouched[root] = this->IsTouched[root] || root != corner;
      corner = root;
    }
    this->IsGone[number] = isCollapsed(t);
  }
  this->dropGone();
}

void FlatRemover::findChains(std::span<const Index> flat)
{
  this->ChainOf.clear();
  this->IsOnLine.assign(this->Mesh.points.size(), false);
  UnionFind sets(flat.size());
  for (Index i = 0; i < flat.size(); ++i)
  {
    const Triangle& t = this->Mesh.triangles[flat[i]];
    for (const Index corner : t)
    {
      this->IsOnLine[corner] = true;
    }
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Index first = this->ChainOf.emplace(keyOf(t[k], t[(k + 1) % 3]), i).first->second;
      if (const Index a = sets.root(first), b = sets.root(i); a != b)
      {
        sets.join(std::min(a, b), std::max(a, b));
      }
    }
  }
  for (auto& [edge, chain] : this->ChainOf)
  {
    chain = sets.root(chain);
  }
  this->Chains.assign(flat.size(), {}); // those of roots are in use
  for (Index i = 0; i < flat.size(); ++i)
  {
    std::vector<Index>& points = this->Chains[sets.root(i)].points;
    const Triangle& t = this->Mesh.triangles[flat[i]];
    points.insert(points.end(), t.begin(), t.end());
  }
  for (Chain& chain : this->Chains)
  {
    std::vector<Index>& points = chain.points;
    std::ranges::sort(points);
    points.erase(std::unique(points.begin(), points.end()), points.end());
    for (double Vec3::*const axis : { &Vec3::x, &Vec3::y, &Vec3::z })
    {
      const bool isLevel = std::ranges::all_of(
        points, [&](Index point) { return this->at(point).*axis == this->at(points[0]).*axis; });
      chain.axis = chain.axis == nullptr && !isLevel ? axis : chain.axis;
    }
    if (chain.axis != nullptr)
    {
      std::ranges::stable_sort(
        points, {}, [&](Index point) { return this->at(point).*chain.axis; });
    }
  }
}

/// Points of a chain in one place become one. @return whether there were such
bool FlatRemover::mergeInChains()
{
  UnionFind sets(this->Mesh.points.size());
  bool isMerged = false;
  for (const Chain& chain : this->Chains)
  {
    for (std::size_t i = 1; i < chain.points.size(); ++i)
    {
      const Index a = sets.root(chain.points[i - 1]);
      const Index b = sets.root(chain.points[i]);
      if (a != b && this->at(a) == this->at(b))
      {
        sets.join(std::min(a, b), std::max(a, b));
        isMerged = true;
      }
    }
  }
  if (isMerged)
  {
    this->mergePoints(sets);
  }
  return isMerged;
}

/// Takes the flat triangles out and cuts all others that have edges of theirs at every point of the
/// chain on these edges. The pieces of these edges meet those of the others: what flat triangles of
/// a line have as their border is, piece by piece, as often there one way as the other.
void FlatRemover::cutAtChains(std::span<const Index> flat)
{
  FlatRemoval result;
  auto next = flat.begin();
  for (Index number = 0; number < this->Mesh.triangles.size(); ++number)
  {
    if (next != flat.end() && *next == number)
    {
      ++next;
      continue;
    }
    this->appendCut(this->Mesh.triangles[number], this->Origin[number], result);
  }
  this->Mesh.triangles = std::move(result.mesh.triangles);
  this->Origin = std::move(result.triangleOrigin);
}

void FlatRemover::appendCut(const Triangle& t, Index origin, FlatRemoval& result)
{
  for (std::size_t k = 0; k < 3; ++k)
  {
    std::vector<Index> ends = this->between(t[k], t[(k + 1) % 3]);
    if (!ends.empty())
    {
      ends.push_back(t[(k + 1) % 3]);
      Index from = t[k];
      for (const Index to : ends)
      {
        this->IsTouched[from] = true;
        this->appendCut({ from, to, t[(k + 2) % 3] }, origin, result);
        from = to;
      }
      return;
    }
  }
  result.mesh.triangles.push_back(t);
  result.triangleOrigin.push_back(origin);
}

/// The points of a chain on one of its edges, in their order; none for other edges.
std::vector<Index> FlatRemover::between(Index from, Index to) const
{
  const auto found = this->IsOnLine[from] && this->IsOnLine[to]
    ? this->ChainOf.find(keyOf(from, to))
    : this->ChainOf.end();
  if (found == this->ChainOf.end())
  {
    return {};
  }
  const Chain& chain = this->Chains[found->second];
  const auto place = [&](Index point) { return this->at(point).*chain.axis; };
  const auto [low, high] = std::minmax({ place(from), place(to) });
  const auto first = std::ranges::upper_bound(chain.points, low, {}, place);
  const auto last = std::ranges::lower_bound(chain.points, high, {}, place);
  std::vector<Index> points(first, last);
  if (place(from) > place(to))
  {
    std::ranges::reverse(points);
  }
  return points;
}

/// Takes flat triangles out and cuts their neighbours along the longest edge, the longest ones
/// first, so that what is cut becomes shorter and this ends.
void FlatRemover::dissolve(std::span<const Index> flat)
{
  this->IsGone.assign(this->Mesh.triangles.size(), false);
  this->IsOnLine.assign(this->Mesh.points.size(), false);
  for (const Index number : flat)
  {
    for (const Index corner : this->Mesh.triangles[number])
    {
      this->IsOnLine[corner] = true;
    }
    this->push(number);
  }
  this->ByEdge.clear();
  for (Index number = 0; number < this->Mesh.triangles.size() && !flat.empty(); ++number)
  {
    this->fileEdges(number);
  }
  // a tolerance hides which of two is longer: this may go round in circles
  std::size_t rest = 16 * (flat.size() + 64);
  for (; !this->Queue.empty() && rest > 0; --rest)
  {
    const Index number = this->Queue.top().second;
    this->Queue.pop();
    if (!this->IsGone[number])
    {
      this->dissolveOne(number);
    }
  }
  this->Queue = {};
}

void FlatRemover::dissolveOne(Index number)
{
  this->IsGone[number] = true;
  const Line line = this->lineOf(this->Mesh.triangles[number]);
  std::vector<Index> neighbours;
  const auto [begin, end] = this->ByEdge.equal_range(keyOf(line.start, line.end));
  for (auto entry = begin; entry != end; ++entry)
  {
    if (!this->IsGone[entry->second])
    {
      neighbours.push_back(entry->second);
    }
  }
  std::ranges::sort(neighbours); // the order of a hash table is nobody's promise
  for (const Index neighbour : neighbours)
  {
    this->cut(neighbour, line);
  }
}

void FlatRemover::fileEdges(Index number)
{
  const Triangle& t = this->Mesh.triangles[number];
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Index a = t[k];
    const Index b = t[(k + 1) % 3];
    if (this->IsOnLine[a] && this->IsOnLine[b])
    {
      this->ByEdge.emplace(keyOf(a, b), number);
    }
  }
}

/// Forgets what is gone and puts the parts of a triangle in its place.
void FlatRemover::dropGone()
{
  std::vector<Index> order;
  for (Index number = 0; number < this->Mesh.triangles.size(); ++number)
  {
    if (!this->IsGone[number])
    {
      order.push_back(number);
    }
  }
  std::ranges::stable_sort(order, {}, [&](Index number) { return this->Origin[number]; });
  std::vector<Triangle> triangles;
  std::vector<Index> origin;
  for (const Index number : order)
  {
    triangles.push_back(this->Mesh.triangles[number]);
    origin.push_back(this->Origin[number]);
  }
  this->Mesh.triangles = std::move(triangles);
  this->Origin = std::move(origin);
}

FlatRemover::Line FlatRemover::lineOf(const Triangle& t) const
{
  const std::size_t k = this->oppositeLongest(t);
  return { t[(k + 2) % 3], t[k], t[(k + 1) % 3] };
}

void FlatRemover::push(Index number)
{
  const Triangle& t = this->Mesh.triangles[number];
  if (this->hasEqualCorners(t))
  {
    return; // for the next round
  }
  const Line line = this->lineOf(t);
  const Vec3 along = this->at(line.end) - this->at(line.start);
  this->Queue.emplace(dot(along, along), number);
}

void FlatRemover::add(const Triangle& t, Index origin)
{
  const auto number = static_cast<Index>(this->Mesh.triangles.size());
  this->Mesh.triangles.push_back(t);
  this->Origin.push_back(origin);
  this->IsGone.push_back(isCollapsed(t));
  this->IsTouched[t[0]] = true;
  if (!this->IsGone.back())
  {
    this->fileEdges(number);
    const bool isOnLine =
      std::ranges::all_of(t, [&](Index corner) { return this->IsOnLine[corner]; });
    if (isOnLine && this->isFlatTriangle(t)) // others have neighbours that were not filed
    {
      this->push(number);
    }
  }
}

/// Makes two of a triangle that has the ends of the line as corners.
void FlatRemover::cut(Index number, const Line& line)
{
  const Triangle t = this->Mesh.triangles[number];
  this->IsGone[number] = true;
  const auto isEnd = [&](Index corner) { return corner == line.start || corner == line.end; };
  const std::size_t apex = !isEnd(t[0]) ? 0 : !isEnd(t[1]) ? 1 : 2;
  const Index from = t[(apex + 1) % 3];
  const Index to = t[(apex + 2) % 3];
  this->add({ from, line.middle, t[apex] }, this->Origin[number]);
  this->add({ line.middle, to, t[apex] }, this->Origin[number]);
}

/// Takes out pairs of triangles that have come to lie upon each other and face opposite sides: what
/// was closed stays closed.
void FlatRemover::cancelFolds()
{
  struct Side
  {
    Triangle corners;
    bool isOdd;
    Index number;
  };
  std::vector<Side> sides;
  for (Index number = 0; number < this->Mesh.triangles.size(); ++number)
  {
    const auto& [a, b, c] = this->Mesh.triangles[number];
    if (this->IsTouched[a] || this->IsTouched[b] || this->IsTouched[c])
    {
      Triangle sorted = { a, b, c };
      std::ranges::sort(sorted);
      sides.push_back({ sorted, isOddPermutation({ a, b, c }), number });
    }
  }
  std::ranges::stable_sort(sides, {}, &Side::corners);
  this->IsGone.assign(this->Mesh.triangles.size(), false);
  for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end)
  {
    std::array<std::vector<Index>, 2> facing;
    for (; end < sides.size() && sides[end].corners == sides[begin].corners; ++end)
    {
      facing[sides[end].isOdd ? 1 : 0].push_back(sides[end].number);
    }
    for (std::size_t i = 0; i < std::min(facing[0].size(), facing[1].size()); ++i)
    {
      this->IsGone[facing[0][i]] = true;
      this->IsGone[facing[1][i]] = true;
    }
  }
  this->dropGone();
}

/// The triangles of which several parts are left.
Index FlatRemover::countCut() const
{
  Index count = 0;
  for (std::size_t i = 1; i < this->Origin.size(); ++i)
  {
    const bool isSecond = this->Origin[i] == this->Origin[i - 1];
    count += isSecond && (i == 1 || this->Origin[i - 2] != this->Origin[i]) ? 1 : 0;
  }
  return count;
}

} // namespace

bool isFlat(const Vec3& a, const Vec3& b, const Vec3& c)
{
  // far more than the rounding of products and differences, relative to what they are made of
  constexpr double kSure = 1e-14;
  const Vec3 u = b - a;
  const Vec3 v = c - a;
  const bool isFinite = std::isfinite(dot(u, u) + dot(v, v));
  return isFinite && largest(cross(u, v)) <= kSure * largest(u) * largest(v) &&
    CGAL::collinear(exact(a), exact(b), exact(c));
}

FlatRemoval removeFlatTriangles(TriMesh mesh, double leastHeight, Execution& execution)
{
  return FlatRemover(std::move(mesh), leastHeight, execution).run();
}

} // namespace scan
