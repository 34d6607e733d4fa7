// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/surface_folds.h"

#include "filters/geometry/incidence.h"
#include "filters/geometry/local_plane.h"
#include "filters/geometry/self_intersections.h"
#include "filters/geometry/triangle_measures.h"
#include "filters/geometry/union_find.h"

#include <algorithm>
#include <iterator>

namespace scan
{
namespace
{

constexpr double kNothing = 1e-3; // of an area

/// More than a quarter turn, in space or in its plane: past the centre of a sphere triangles face
/// as before, point by point opposite.
bool isTurnedOver(const TriMesh& mesh, std::span<const Vec3> before, const Triangle& triangle)
{
  double along = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Index a = triangle[k];
    const Index b = triangle[(k + 1) % 3];
    along += dot(before[b] - before[a], mesh.points[b] - mesh.points[a]);
  }
  return along < 0.0 || dot(areaVector(before, triangle), areaVector(mesh.points, triangle)) < 0.0;
}

void findTurned(const TriMesh& mesh, std::span<const Vec3> before, SurfaceFolds& folds)
{
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    const Vec3 was = areaVector(before, mesh.triangles[t]);
    const Vec3 is = areaVector(mesh.points, mesh.triangles[t]);
    if (was == Vec3{} || was == is)
    {
      continue;
    }
    const bool isTurned = isTurnedOver(mesh, before, mesh.triangles[t]);
    const bool isShrunk = !isTurned && length(is) <= kNothing * length(was);
    folds.turned += isTurned ? 1 : 0;
    folds.shrunk += isShrunk ? 1 : 0;
    folds.isFolded[t] = isTurned || isShrunk ? 1 : 0;
  }
}

/// The pairs that count.
std::vector<TrianglePair> findCrossings(
  const TriMesh& mesh, std::span<const Vec3> before, SurfaceFolds& folds, Execution& execution)
{
  const auto isMoved = [&](Index t)
  {
    return std::ranges::any_of(
      mesh.triangles[t], [&](Index p) { return mesh.points[p] != before[p]; });
  };
  std::vector<TrianglePair> pairs = selfIntersections(mesh, execution);
  std::erase_if(
    pairs, [&](const TrianglePair& pair) { return !isMoved(pair[0]) && !isMoved(pair[1]); });
  std::vector<std::uint8_t> isCrossing(mesh.triangles.size(), 0);
  for (const TrianglePair& pair : pairs)
  {
    isCrossing[pair[0]] = isCrossing[pair[1]] = 1;
    folds.isFolded[pair[0]] = folds.isFolded[pair[1]] = 1;
  }
  folds.crossing = static_cast<Index>(std::ranges::count(isCrossing, 1));
  return pairs;
}

/// The folded triangle of a group that is nearest to the middle of all of them.
Vec3 placeOf(const TriMesh& mesh, std::span<const Index> group)
{
  const Vec3 origin = middleOf(mesh.points, mesh.triangles[group.front()]);
  Vec3 sum;
  for (const Index t : group)
  {
    sum = sum + (middleOf(mesh.points, mesh.triangles[t]) - origin);
  }
  const Vec3 mean = origin + sum * (1.0 / static_cast<double>(group.size()));
  const auto distance = [&](Index t)
  {
    const Vec3 d = middleOf(mesh.points, mesh.triangles[t]) - mean;
    return dot(d, d);
  };
  return middleOf(mesh.points, mesh.triangles[*std::ranges::min_element(group, {}, distance)]);
}

/// Folded triangles hang together where they share a point or cross.
std::vector<Vec3> placesOf(const TriMesh& mesh, const std::vector<std::uint8_t>& isFolded,
  const std::vector<TrianglePair>& pairs)
{
  UnionFind groups(mesh.triangles.size());
  std::vector<Index> firstAt(mesh.points.size(), kNone);
  for (Index t = 0; t < isFolded.size(); ++t)
  {
    for (const Index point : mesh.triangles[t])
    {
      if (isFolded[t] != 0 && firstAt[point] == kNone)
      {
        firstAt[point] = t;
      }
      else if (isFolded[t] != 0)
      {
        groups.unite(firstAt[point], t);
      }
    }
  }
  std::ranges::for_each(pairs, [&](const TrianglePair& pair) { groups.unite(pair[0], pair[1]); });
  const Incidence members(mesh.triangles.size(), mesh.triangles.size(),
    [&](std::size_t t, auto&& visit)
    {
      if (isFolded[t] != 0)
      {
        visit(groups.root(static_cast<Index>(t)));
      }
    });
  std::vector<Index> roots;
  for (Index t = 0; t < isFolded.size(); ++t)
  {
    if (!members.of(t).empty())
    {
      roots.push_back(t);
    }
  }
  std::ranges::stable_sort(
    roots, std::ranges::greater{}, [&](Index root) { return members.of(root).size(); });
  std::vector<Vec3> places;
  std::ranges::transform(
    roots, std::back_inserter(places), [&](Index root) { return placeOf(mesh, members.of(root)); });
  return places;
}

} // namespace

SurfaceFolds findFolds(const TriMesh& mesh, std::span<const Vec3> before, Execution& execution)
{
  SurfaceFolds folds;
  folds.isFolded.assign(mesh.triangles.size(), 0);
  findTurned(mesh, before, folds);
  const std::vector<TrianglePair> pairs = findCrossings(mesh, before, folds, execution);
  folds.folded = static_cast<Index>(std::ranges::count(folds.isFolded, 1));
  if (folds.folded > 0)
  {
    folds.places = placesOf(mesh, folds.isFolded, pairs);
  }
  return folds;
}

} // namespace scan
