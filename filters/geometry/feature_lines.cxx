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

constexpr std::size_t kFewest = 6; // edges that make a line

/// Both ends of every edge that bends by more than the angle.
std::vector<Segment> bentEdges(
  const TriMesh& mesh, std::span<const Vec3> normals, double angle, Execution& execution)
{
  const EdgePairs pairs = pairEdges(mesh, execution);
  const double least = std::cos(angle);
  std::vector<Segment> edges;
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
    if (here != Vec3{} && there != Vec3{} && sign * dot(here, there) < least)
    {
      edges.push_back({ origin, originOf(mesh, nextHalf(half)) });
    }
  }
  return edges;
}

void dropSmallGroups(std::vector<Segment>& edges, std::size_t points)
{
  UnionFind groups(points);
  for (const auto& [a, b] : edges)
  {
    groups.unite(a, b);
  }
  std::vector<Index> sizes(points, 0);
  for (const Segment& edge : edges)
  {
    ++sizes[groups.root(edge[0])];
  }
  std::erase_if(edges, [&](const Segment& edge) { return sizes[groups.root(edge[0])] < kFewest; });
}

} // namespace

FeatureLines findFeatureLines(
  const TriMesh& mesh, std::span<const Vec3> normals, double angle, Execution& execution)
{
  std::vector<Segment> edges = bentEdges(mesh, normals, angle, execution);
  dropSmallGroups(edges, mesh.points.size());
  std::vector<std::array<Index, 2>> directed;
  for (const auto& [a, b] : edges)
  {
    directed.push_back({ a, b });
    directed.push_back({ b, a });
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
