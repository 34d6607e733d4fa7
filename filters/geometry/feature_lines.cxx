// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/feature_lines.h"

#include "filters/geometry/half_edges.h"
#include "filters/geometry/union_find.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace scan
{
namespace
{

constexpr std::size_t kFewest = 6; // sharp edges that make a line
constexpr double kWeaker = 0.6;    // of the angle, where a line goes on

struct BentEdge
{
  Segment ends;
  bool isSharp = false; ///< by more than the whole angle
};

/// Every edge that bends by more than the weaker angle.
std::vector<BentEdge> bentEdges(
  const TriMesh& mesh, std::span<const Vec3> normals, double angle, Execution& execution)
{
  const EdgePairs pairs = pairEdges(mesh, execution);
  std::vector<BentEdge> edges;
  for (Index half = 0; half < pairs.mate.size(); ++half)
  {
    const Index mate = pairs.mate[half];
    if (mate == kNone || mate < half)
    {
      continue;
    }
    const Index origin = originOf(mesh, half);
    const double sign = origin == originOf(mesh, mate) ? -1.0 : 1.0;
    const Vec3& here = normals[half / 3];
    const Vec3& there = normals[mate / 3];
    const double cosine = sign * dot(here, there);
    if (here != Vec3{} && there != Vec3{} && cosine < std::cos(kWeaker * angle))
    {
      edges.push_back({ { origin, originOf(mesh, nextHalf(half)) }, cosine < std::cos(angle) });
    }
  }
  return edges;
}

/// Leaves out what hangs together without enough sharp edges.
void dropWeakLines(std::vector<BentEdge>& edges, std::size_t points)
{
  UnionFind lines(points);
  for (const BentEdge& edge : edges)
  {
    lines.unite(edge.ends[0], edge.ends[1]);
  }
  std::vector<Index> sharp(points, 0);
  for (const BentEdge& edge : edges)
  {
    sharp[lines.root(edge.ends[0])] += edge.isSharp ? 1 : 0;
  }
  std::erase_if(
    edges, [&](const BentEdge& edge) { return sharp[lines.root(edge.ends[0])] < kFewest; });
}

} // namespace

FeatureLines findFeatureLines(
  const TriMesh& mesh, std::span<const Vec3> normals, double angle, Execution& execution)
{
  std::vector<BentEdge> edges = bentEdges(mesh, normals, angle, execution);
  dropWeakLines(edges, mesh.points.size());
  std::vector<Segment> directed;
  for (const BentEdge& edge : edges)
  {
    directed.push_back(edge.ends);
    directed.push_back({ edge.ends[1], edge.ends[0] });
  }
  std::ranges::sort(directed);
  FeatureLines lines;
  lines.edges = edges.size();
  std::size_t place = 0;
  lines.along = makeLists(
    mesh.points.size(), execution,
    [&](std::size_t point)
    {
      const std::size_t begin = place;
      while (place < directed.size() && directed[place][0] == point)
      {
        ++place;
      }
      lines.corners += place > begin && place - begin != 2 ? 1 : 0;
      return static_cast<Index>(place - begin);
    },
    [](std::size_t, std::span<Index>) {});
  std::ranges::transform(
    directed, lines.along.items.begin(), [](const auto& ends) { return ends[1]; });
  return lines;
}

} // namespace scan
