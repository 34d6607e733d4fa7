// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/consistent_surface.h"

#include "filters/geometry/flat_triangles.h"
#include "filters/geometry/half_edges.h"
#include "filters/geometry/mesh_orient.h"
#include "filters/geometry/mesh_split.h"
#include "filters/geometry/shells.h"

#include <algorithm>
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

/// Takes out all but the first of triangles with the same points. @return whether there were some
bool removeRepeats(ConsistentSurface& surface, const EdgePairs& pairs)
{
  std::vector<std::pair<Triangle, Index>> known;
  for (const Index number : candidatesForRepeats(pairs))
  {
    Triangle corners = surface.mesh.triangles[number];
    std::ranges::sort(corners);
    known.emplace_back(corners, number);
  }
  std::ranges::sort(known);
  std::vector<bool> isRepeat(surface.mesh.triangles.size());
  for (std::size_t i = 1; i < known.size(); ++i)
  {
    isRepeat[known[i].second] = known[i].first == known[i - 1].first;
  }
  surface.changes.repeats = static_cast<Index>(std::ranges::count(isRepeat, true));
  std::size_t kept = 0;
  for (std::size_t t = 0; t < isRepeat.size() && surface.changes.repeats > 0; ++t)
  {
    surface.mesh.triangles[kept] = surface.mesh.triangles[t];
    surface.triangleOrigin[kept] = surface.triangleOrigin[t];
    kept += isRepeat[t] ? 0 : 1;
  }
  if (surface.changes.repeats > 0)
  {
    surface.mesh.triangles.resize(kept);
    surface.triangleOrigin.resize(kept);
  }
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
  const std::vector<Triangle> before = surface.mesh.triangles;
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
  turnOutwards(surface.mesh, split.mate, execution);
  surface.isTurned.resize(before.size());
  for (std::size_t t = 0; t < before.size(); ++t)
  {
    surface.isTurned[t] = isTurned(before[t], surface.mesh.triangles[t], surface.pointOrigin);
    surface.changes.turned += surface.isTurned[t] ? 1 : 0;
  }
  return surface;
}

} // namespace scan
