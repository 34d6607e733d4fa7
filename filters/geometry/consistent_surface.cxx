// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/consistent_surface.h"

#include "filters/geometry/flat_triangles.h"
#include "filters/geometry/half_edges.h"
#include "filters/geometry/mesh_orient.h"
#include "filters/geometry/mesh_split.h"
#include "filters/geometry/shells.h"

#include <algorithm>
#include <span>
#include <utility>

namespace scan
{
namespace
{

void turn(Triangle& triangle)
{
  std::swap(triangle[1], triangle[2]);
}

/// Takes out what has no area.
void removeFlat(ConsistentSurface& surface, double leastHeight, Execution& execution)
{
  const auto before = static_cast<Index>(surface.mesh.triangles.size());
  FlatRemoval removal = removeFlatTriangles(std::move(surface.mesh), leastHeight, execution);
  surface.mesh = std::move(removal.mesh);
  surface.triangleOrigin = std::move(removal.triangleOrigin);
  surface.cuts = removal.cuts;
  std::vector<Index> left = surface.triangleOrigin; // parts of one follow each other
  left.erase(std::unique(left.begin(), left.end()), left.end());
  surface.removed = before - static_cast<Index>(left.size());
}

/// Turns the smaller part of each piece in which neighbours disagree.
Index turnDissenters(TriMesh& mesh, const EdgePairs& pairs)
{
  const std::vector<Triangle> before = mesh.triangles;
  orientConsistently(mesh.triangles, mesh.points.size());
  const Shells pieces = findShells(mesh, pairs.mate);
  std::vector<Index> turnedIn(pieces.shells.size(), 0);
  for (std::size_t t = 0; t < before.size(); ++t)
  {
    turnedIn[pieces.shellOf[t]] += mesh.triangles[t] != before[t] ? 1 : 0;
  }
  Index turned = 0;
  for (std::size_t t = 0; t < before.size(); ++t)
  {
    const Index piece = pieces.shellOf[t];
    if (turnedIn[piece] > pieces.shells[piece].triangles / 2)
    {
      turn(mesh.triangles[t]);
    }
    turned += mesh.triangles[t] != before[t] ? 1 : 0;
  }
  return turned;
}

/// Turns closed pieces that face inwards and are in no other, with what is in them: voids stay
/// voids.
Index turnOutwards(TriMesh& mesh, std::span<const Index> mate, Execution& execution)
{
  Shells shells = findShells(mesh, mate);
  if (std::ranges::none_of(shells.shells, [](const Shell& shell) { return shell.volume < 0.0; }))
  {
    return 0;
  }
  findContainers(mesh, shells, execution);
  Index turned = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    if (shells.shells[outermost(shells, shells.shellOf[t])].volume < 0.0)
    {
      turn(mesh.triangles[t]);
      ++turned;
    }
  }
  return turned;
}

} // namespace

ConsistentSurface makeConsistent(TriMesh mesh, double leastHeight, Execution& execution)
{
  requireCorners(mesh);
  ConsistentSurface surface{ .mesh = std::move(mesh) };
  removeFlat(surface, leastHeight, execution);
  EdgePairs pairs = pairEdges(surface.mesh, execution);
  if (!pairs.misoriented.empty())
  {
    surface.turned = turnDissenters(surface.mesh, pairs);
    pairs = pairEdges(surface.mesh, execution);
  }
  SplitResult split = splitNonManifold(std::move(surface.mesh), std::move(pairs), execution);
  surface.mesh = std::move(split.mesh);
  surface.edgesSplit = split.edgesSplit;
  surface.verticesSplit = split.verticesSplit;
  surface.pointOrigin = std::move(split.pointOrigin);
  surface.turned += turnOutwards(surface.mesh, split.mate, execution);
  return surface;
}

} // namespace scan
