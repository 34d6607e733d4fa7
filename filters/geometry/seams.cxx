// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/seams.h"

#include "filters/geometry/union_find.h"

#include <algorithm>
#include <utility>

namespace scan
{
namespace
{

using Place = std::array<double, 3>;

Place placeOf(const Vec3& p)
{
  return { p.x + 0.0, p.y + 0.0, p.z + 0.0 }; // no negative zeros
}

} // namespace

std::vector<SeamEdge> findSeams(const TriMesh& mesh, const EdgePairs& pairs)
{
  std::vector<bool> isCrowded(pairs.mate.size());
  for (const Index half : pairs.crowded)
  {
    isCrowded[half] = true;
  }
  std::vector<std::pair<std::array<Place, 2>, Index>> edges;
  for (Index half = 0; half < pairs.mate.size(); ++half)
  {
    if (pairs.mate[half] == kNone && !isCrowded[half] && !isCollapsed(mesh.triangles[half / 3]))
    {
      const Place a = placeOf(mesh.points[originOf(mesh, half)]);
      const Place b = placeOf(mesh.points[originOf(mesh, nextHalf(half))]);
      edges.push_back({ { std::min(a, b), std::max(a, b) }, half });
    }
  }
  std::ranges::sort(edges);
  std::vector<SeamEdge> seams;
  for (std::size_t i = 0; i < edges.size();)
  {
    std::size_t k = i + 1;
    while (k < edges.size() && edges[k].first == edges[i].first)
    {
      ++k;
    }
    const auto& [a, b] = edges[i].first;
    if (k - i == 2 && a != b && edges[i].second / 3 != edges[i + 1].second / 3)
    {
      seams.push_back({ edges[i].second, edges[i + 1].second });
    }
    i = k;
  }
  std::ranges::sort(seams);
  return seams;
}

void closeSeams(TriMesh& mesh, std::span<const SeamEdge> seams)
{
  if (seams.empty())
  {
    return;
  }
  UnionFind sets(mesh.points.size());
  for (const auto& [a, b] : seams)
  {
    Index from = originOf(mesh, b);
    Index to = originOf(mesh, nextHalf(b));
    if (mesh.points[from] != mesh.points[originOf(mesh, a)])
    {
      std::swap(from, to);
    }
    sets.unite(originOf(mesh, a), from);
    sets.unite(originOf(mesh, nextHalf(a)), to);
  }
  for (Triangle& t : mesh.triangles)
  {
    for (Index& corner : t)
    {
      corner = sets.root(corner);
    }
  }
}

} // namespace scan
