// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/orient_outward.h"

#include "filters/geometry/mesh_orient.h"
#include "filters/geometry/shells.h"

#include <algorithm>
#include <utility>

namespace scan
{
namespace
{

void turn(Triangle& triangle)
{
  std::swap(triangle[1], triangle[2]);
}

/// Undoes what happened to shells without a triangle of the region.
void keepOutside(const std::vector<Triangle>& before, std::span<const std::uint8_t> inRegion,
  const Shells& shells, std::vector<Triangle>& triangles)
{
  std::vector<bool> isChosen(shells.shells.size());
  for (std::size_t t = 0; t < before.size(); ++t)
  {
    if (inRegion[t] != 0)
    {
      isChosen[shells.shellOf[t]] = true;
    }
  }
  for (std::size_t t = 0; t < before.size(); ++t)
  {
    if (!isChosen[shells.shellOf[t]])
    {
      triangles[t] = before[t];
    }
  }
}

/// Pieces in which neighbours disagree.
Index disagreeing(const EdgePairs& pairs, const Shells& shells)
{
  std::vector<Index> pieces;
  for (const Index half : pairs.misoriented)
  {
    pieces.push_back(shells.shellOf[half / 3]);
  }
  std::ranges::sort(pieces);
  return static_cast<Index>(std::unique(pieces.begin(), pieces.end()) - pieces.begin());
}

} // namespace

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

OrientResult orientSurface(const TriMesh& mesh, std::span<const std::uint8_t> inRegion,
  const OrientOptions& options, Execution& execution)
{
  TriMesh oriented = mesh;
  OrientResult result;
  EdgePairs pairs = pairEdges(mesh, execution);
  const Shells shells = findShells(mesh, pairs.mate);
  result.pieces = static_cast<Index>(shells.shells.size());
  if (options.flip)
  {
    for (std::size_t t = 0; t < inRegion.size(); ++t)
    {
      if (inRegion[t] != 0)
      {
        turn(oriented.triangles[t]);
      }
    }
  }
  else
  {
    if (!pairs.misoriented.empty())
    {
      turnDissenters(oriented, pairs);
      pairs = pairEdges(oriented, execution);
    }
    if (options.outward)
    {
      turnOutwards(oriented, pairs.mate, execution);
    }
    keepOutside(mesh.triangles, inRegion, shells, oriented.triangles);
  }
  result.disagreeingPieces = disagreeing(pairEdges(oriented, execution), shells);
  result.triangles = std::move(oriented.triangles);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    result.turned += result.triangles[t] != mesh.triangles[t] ? 1 : 0;
  }
  return result;
}

} // namespace scan
