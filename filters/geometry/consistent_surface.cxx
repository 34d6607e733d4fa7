// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/consistent_surface.h"

#include "filters/geometry/flat_triangles.h"
#include "filters/geometry/half_edges.h"
#include "filters/geometry/mesh_orient.h"
#include "filters/geometry/mesh_split.h"
#include "filters/geometry/shells.h"
#include "filters/geometry/union_find.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

namespace scan
{
namespace
{

void turn(Triangle& triangle)
{
  std::swap(triangle[1], triangle[2]);
}

/// Triangles with the same points as others: they share edges that have too many triangles, or
/// three edges with one other triangle.
std::vector<Index> candidatesForRepeats(const EdgePairs& pairs)
{
  std::vector<Index> candidates;
  for (const Index half : pairs.crowded)
  {
    candidates.push_back(half / 3);
  }
  for (Index half = 0; half < pairs.mate.size(); half += 3)
  {
    const auto other = [&](Index k) { return pairs.mate[half + k] / 3; };
    if (pairs.mate[half] != kNone && other(0) == other(1) && other(1) == other(2))
    {
      candidates.push_back(half / 3);
    }
  }
  std::ranges::sort(candidates);
  candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());
  return candidates;
}

/// Triangles with the same points.
using Repeats = std::vector<std::vector<Index>>;

Repeats findRepeats(const TriMesh& mesh, const EdgePairs& pairs)
{
  std::vector<std::pair<Triangle, Index>> known;
  for (const Index number : candidatesForRepeats(pairs))
  {
    Triangle corners = mesh.triangles[number];
    std::ranges::sort(corners);
    known.emplace_back(corners, number);
  }
  std::ranges::sort(known);
  Repeats repeats;
  for (std::size_t i = 1; i < known.size(); ++i)
  {
    if (known[i].first == known[i - 1].first)
    {
      const bool isThird = i > 1 && known[i].first == known[i - 2].first;
      if (!isThird)
      {
        repeats.push_back({ known[i - 1].second });
      }
      repeats.back().push_back(known[i].second);
    }
  }
  return repeats;
}

/// Tells walls from double layers: at all edges of a wall as many triangles run one way as the
/// other, so that it parts closed pieces, and other triangles meet it.
class WallSearch
{
public:
  /// @param isLeftOut per triangle: whether it does not count
  WallSearch(const TriMesh& mesh, const EdgePairs& pairs, const Repeats& repeats,
    const std::vector<bool>& isLeftOut)
    : Mesh(mesh)
    , IsLeftOut(isLeftOut)
    , Sets(repeats.size())
    , Group(mesh.triangles.size(), kNone)
    , IsBalanced(repeats.size(), true)
    , HasNeighbours(repeats.size(), false)
  {
    for (Index i = 0; i < repeats.size(); ++i)
    {
      for (const Index number : repeats[i])
      {
        this->Group[number] = i;
      }
    }
    this->forEachEdge(pairs, repeats, [this](auto halves) { this->joinAt(halves); });
    this->forEachEdge(pairs, repeats, [this](auto halves) { this->seeEdge(halves); });
  }

  bool isWall(Index group)
  {
    const Index root = this->Sets.root(group);
    return this->IsBalanced[root] && this->HasNeighbours[root];
  }

private:
  template <class Visit>
  void forEachEdge(const EdgePairs& pairs, const Repeats& repeats, const Visit& visit)
  {
    const std::span<const Index> crowded = pairs.crowded;
    for (std::size_t i = 1; i < pairs.crowdedBegin.size(); ++i)
    {
      const Index begin = pairs.crowdedBegin[i - 1];
      visit(crowded.subspan(begin, pairs.crowdedBegin[i] - begin));
    }
    for (const std::vector<Index>& group : repeats)
    {
      for (Index half = 3 * group.front(); half < 3 * group.front() + 3; ++half)
      {
        if (pairs.mate[half] != kNone)
        {
          visit(std::span<const Index>(std::array{ half, pairs.mate[half] }));
        }
      }
    }
  }

  void joinAt(std::span<const Index> halves)
  {
    Index first = kNone;
    for (const Index half : halves)
    {
      const Index group = this->Group[half / 3];
      if (group != kNone)
      {
        const Index root = this->Sets.root(group);
        first = first == kNone ? root : this->Sets.root(first);
        if (root != first)
        {
          this->Sets.join(first, root);
        }
      }
    }
  }

  void seeEdge(std::span<const Index> halves)
  {
    Index root = kNone;
    int balance = 0;
    bool hasNeighbours = false;
    for (const Index half : halves)
    {
      if (this->IsLeftOut[half / 3])
      {
        continue;
      }
      const Index group = this->Group[half / 3];
      root = group != kNone ? this->Sets.root(group) : root;
      hasNeighbours = hasNeighbours || group == kNone;
      balance += originOf(this->Mesh, half) < originOf(this->Mesh, nextHalf(half)) ? 1 : -1;
    }
    if (root != kNone)
    {
      this->IsBalanced[root] = this->IsBalanced[root] && balance == 0;
      this->HasNeighbours[root] = this->HasNeighbours[root] || hasNeighbours;
    }
  }

  const TriMesh& Mesh;
  const std::vector<bool>& IsLeftOut;
  UnionFind Sets;           // of groups that share edges
  std::vector<Index> Group; // per triangle; kNone of those that nothing repeats
  std::vector<bool> IsBalanced;
  std::vector<bool> HasNeighbours;
};

/// @return the new number of each triangle; kNone of those that are gone
std::vector<Index> dropTriangles(ConsistentSurface& surface, const std::vector<bool>& isGone)
{
  std::vector<Index> number(isGone.size(), kNone);
  Index kept = 0;
  for (std::size_t t = 0; t < isGone.size(); ++t)
  {
    if (!isGone[t])
    {
      surface.mesh.triangles[kept] = surface.mesh.triangles[t];
      surface.triangleOrigin[kept] = surface.triangleOrigin[t];
      number[t] = kept;
      ++kept;
    }
  }
  surface.mesh.triangles.resize(kept);
  surface.triangleOrigin.resize(kept);
  return number;
}

/// Marks all of a group but one: the first that faces as most of them do.
void leaveOneOf(const std::vector<Index>& group, const TriMesh& mesh, std::vector<bool>& isLeftOut)
{
  const auto isOdd = [&](Index number) { return isOddPermutation(mesh.triangles[number]); };
  const auto odd = static_cast<std::size_t>(std::ranges::count_if(group, isOdd));
  const bool isMostlyOdd = 2 * odd > group.size() || (2 * odd == group.size() && isOdd(group[0]));
  const Index kept =
    *std::ranges::find_if(group, [&](Index number) { return isOdd(number) == isMostlyOdd; });
  for (const Index number : group)
  {
    isLeftOut[number] = number != kept;
  }
}

/// Takes out all but one of triangles with the same points, other than in walls.
/// @return whether there were some
bool removeRepeats(ConsistentSurface& surface, const EdgePairs& pairs)
{
  Repeats repeats = findRepeats(surface.mesh, pairs);
  if (repeats.empty())
  {
    return false;
  }
  std::vector<bool> isLeftOut(surface.mesh.triangles.size());
  std::erase_if(repeats,
    [&](const std::vector<Index>& group)
    {
      const bool isLayer = group.size() % 2 == 1; // with or without pairs that cancel
      if (isLayer)
      {
        leaveOneOf(group, surface.mesh, isLeftOut);
      }
      return isLayer;
    });
  WallSearch walls(surface.mesh, pairs, repeats, isLeftOut);
  for (Index i = 0; i < repeats.size(); ++i)
  {
    if (!walls.isWall(i))
    {
      leaveOneOf(repeats[i], surface.mesh, isLeftOut);
    }
  }
  surface.changes.repeats = static_cast<Index>(std::ranges::count(isLeftOut, true));
  dropTriangles(surface, isLeftOut);
  return surface.changes.repeats > 0;
}

/// Takes out what has no area. @return whether there was such
bool removeFlat(ConsistentSurface& surface, double leastHeight, Execution& execution)
{
  const auto before = static_cast<Index>(surface.mesh.triangles.size());
  FlatRemoval removal = removeFlatTriangles(std::move(surface.mesh), leastHeight, execution);
  surface.mesh = std::move(removal.mesh);
  std::vector<Index> left = removal.triangleOrigin; // parts of one follow each other
  left.erase(std::unique(left.begin(), left.end()), left.end());
  surface.changes.cut = removal.cut;
  surface.changes.removed = before - static_cast<Index>(left.size());
  std::ranges::transform(removal.triangleOrigin, removal.triangleOrigin.begin(),
    [&](Index number) { return surface.triangleOrigin[number]; });
  surface.triangleOrigin = std::move(removal.triangleOrigin);
  return surface.changes.cut + surface.changes.removed > 0;
}

/// Turns the smaller part of each piece in which neighbours disagree.
void turnDissenters(TriMesh& mesh, const EdgePairs& pairs)
{
  const std::vector<Triangle> before = mesh.triangles;
  orientConsistently(mesh.triangles, mesh.points.size());
  const Shells pieces = findShells(mesh, pairs.mate);
  std::vector<Index> turnedIn(pieces.shells.size(), 0);
  for (std::size_t t = 0; t < before.size(); ++t)
  {
    turnedIn[pieces.shellOf[t]] += mesh.triangles[t] != before[t] ? 1 : 0;
  }
  for (std::size_t t = 0; t < before.size(); ++t)
  {
    const Index piece = pieces.shellOf[t];
    if (turnedIn[piece] > pieces.shells[piece].triangles / 2)
    {
      turn(mesh.triangles[t]);
    }
  }
}

/// Turns closed pieces that face inwards and are in no other, with what is in them: voids stay
/// voids.
void turnOutwards(TriMesh& mesh, std::span<const Index> mate, Execution& execution)
{
  Shells shells = findShells(mesh, mate);
  if (std::ranges::none_of(shells.shells, [](const Shell& shell) { return shell.volume < 0.0; }))
  {
    return;
  }
  findContainers(mesh, shells, execution);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    if (shells.shells[outermost(shells, shells.shellOf[t])].volume < 0.0)
    {
      turn(mesh.triangles[t]);
    }
  }
}

/// Takes out pairs of triangles back to back that splitting has made of walls that part nothing.
/// @param before further values per triangle
void removePillows(
  ConsistentSurface& surface, std::vector<Index>& mate, std::vector<Triangle>& before)
{
  std::vector<bool> isPillow(surface.mesh.triangles.size());
  for (Index t = 0; t < isPillow.size(); ++t)
  {
    const auto other = [&](Index k) { return mate[3 * t + k] == kNone ? t : mate[3 * t + k] / 3; };
    isPillow[t] = other(0) != t && other(0) == other(1) && other(1) == other(2);
  }
  const auto pillows = static_cast<Index>(std::ranges::count(isPillow, true));
  if (pillows == 0)
  {
    return;
  }
  surface.changes.repeats += pillows;
  const std::vector<Index> number = dropTriangles(surface, isPillow);
  for (Index t = 0; t < number.size(); ++t)
  {
    if (number[t] == kNone)
    {
      continue;
    }
    before[number[t]] = before[t];
    for (Index k = 0; k < 3; ++k)
    {
      const Index half = mate[3 * t + k];
      mate[3 * number[t] + k] = half == kNone ? kNone : 3 * number[half / 3] + half % 3;
    }
  }
  before.resize(surface.mesh.triangles.size());
  mate.resize(3 * surface.mesh.triangles.size());
}

/// Whether the triangle is the other way round. Its points may have become copies.
bool isTurned(const Triangle& before, const Triangle& after, const std::vector<Index>& pointOrigin)
{
  return pointOrigin[after[1]] != before[1];
}

} // namespace

SurfaceChanges& SurfaceChanges::operator+=(const SurfaceChanges& other)
{
  this->removed += other.removed;
  this->repeats += other.repeats;
  this->cut += other.cut;
  this->turned += other.turned;
  this->edgesSplit += other.edgesSplit;
  this->verticesSplit += other.verticesSplit;
  return *this;
}

ConsistentSurface makeConsistent(TriMesh mesh, double leastHeight, Execution& execution)
{
  requireCorners(mesh);
  ConsistentSurface surface{ .mesh = std::move(mesh) };
  surface.triangleOrigin.resize(surface.mesh.triangles.size());
  std::iota(surface.triangleOrigin.begin(), surface.triangleOrigin.end(), Index{ 0 });
  EdgePairs pairs = pairEdges(surface.mesh, execution);
  const bool hadRepeats = removeRepeats(surface, pairs);
  const bool hadFlat = removeFlat(surface, leastHeight, execution);
  if (hadRepeats || hadFlat)
  {
    pairs = pairEdges(surface.mesh, execution);
  }
  std::vector<Triangle> before = surface.mesh.triangles;
  if (!pairs.misoriented.empty())
  {
    turnDissenters(surface.mesh, pairs);
    pairs = pairEdges(surface.mesh, execution);
  }
  SplitResult split = splitNonManifold(std::move(surface.mesh), std::move(pairs), execution);
  surface.mesh = std::move(split.mesh);
  surface.changes.edgesSplit = split.edgesSplit;
  surface.changes.verticesSplit = split.verticesSplit;
  surface.pointOrigin = std::move(split.pointOrigin);
  removePillows(surface, split.mate, before);
  turnOutwards(surface.mesh, split.mate, execution);
  surface.isTurned.resize(before.size());
  for (std::size_t t = 0; t < before.size(); ++t)
  {
    surface.isTurned[t] = isTurned(before[t], surface.mesh.triangles[t], surface.pointOrigin);
    surface.changes.turned += surface.isTurned[t] ? 1 : 0;
  }
  return surface;
}

std::string describe(const SurfaceChanges& changes)
{
  std::string text;
  const auto add = [&](Index number, const char* thing, const char* what)
  {
    if (number > 0)
    {
      text += text.empty() ? "the surface is mended: " : ", ";
      text += std::to_string(number) + " " + thing + (number == 1 ? "" : "s") + " " + what;
    }
  };
  add(changes.removed, "triangle", "without area left out");
  add(changes.repeats, "repeated triangle", "left out");
  add(changes.cut, "triangle", "cut");
  add(changes.turned, "triangle", "turned over");
  add(changes.edgesSplit, "edge", "split");
  add(changes.verticesSplit, "point", "repeated");
  return text;
}

} // namespace scan
