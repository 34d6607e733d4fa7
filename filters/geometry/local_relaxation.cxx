// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/local_relaxation.h"

#include "filters/geometry/half_edges.h"
#include "filters/geometry/intersecting.h"
#include "filters/geometry/local_plane.h"
#include "filters/geometry/spikes.h"
#include "filters/geometry/union_find.h"
#include "filters/geometry/vertex_normals.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace scan
{
namespace
{

/// Shares of the mean edge at a point, against the normal or towards the neighbours.
constexpr std::array kPulls{ std::pair(0.02, true), std::pair(0.02, false), std::pair(0.08, true),
  std::pair(0.08, false), std::pair(0.3, true), std::pair(0.3, false) };
constexpr int kMostRings = 4;
constexpr double kMostShift = 1.5; // mean, in edges
constexpr int kSteps = 10;         // of relaxation, a ring

/// Where points were before they moved.
using Before = std::map<Index, Vec3>;

std::vector<std::uint8_t> boundaryPoints(const TriMesh& mesh, const EdgePairs& pairs)
{
  std::vector<std::uint8_t> isOn(mesh.points.size(), 0);
  for (Index half = 0; half < pairs.mate.size(); ++half)
  {
    if (pairs.mate[half] == kNone)
    {
      isOn[originOf(mesh, half)] = isOn[originOf(mesh, nextHalf(half))] = 1;
    }
  }
  return isOn;
}

/// The points of some triangles that share their place with others of them, rising. Where some of
/// those in a place are on the boundary only these, so that closed pieces stay as they are.
std::vector<Index> touchingPoints(const TriMesh& mesh, const std::vector<Index>& triangles,
  const std::vector<std::uint8_t>& isOnBoundary)
{
  std::vector<std::pair<std::array<double, 3>, Index>> places;
  for (const Index t : triangles)
  {
    for (const Index point : mesh.triangles[t])
    {
      const Vec3& p = mesh.points[point];
      places.push_back({ { p.x, p.y, p.z }, point });
    }
  }
  std::ranges::sort(places);
  places.erase(std::unique(places.begin(), places.end()), places.end());
  std::vector<Index> touching;
  for (std::size_t i = 0; i < places.size();)
  {
    std::size_t end = i;
    bool hasBoundary = false;
    for (; end < places.size() && places[end].first == places[i].first; ++end)
    {
      hasBoundary = hasBoundary || isOnBoundary[places[end].second] != 0;
    }
    for (std::size_t k = i; end - i > 1 && k < end; ++k)
    {
      if (!hasBoundary || isOnBoundary[places[k].second] != 0)
      {
        touching.push_back(places[k].second);
      }
    }
    i = end;
  }
  std::ranges::sort(touching);
  return touching;
}

/// The mean of the neighbours of a point, and of the lengths of the edges to them.
std::pair<Vec3, double> neighbourhood(
  const TriMesh& mesh, const Incidence& trianglesAt, Index point)
{
  Vec3 sum;
  double lengths = 0.0;
  double count = 0.0;
  for (const Index t : trianglesAt.of(point)) // those inside a fan come twice
  {
    for (const Index other : mesh.triangles[t])
    {
      if (other != point)
      {
        sum = sum + mesh.points[other];
        lengths += length(mesh.points[other] - mesh.points[point]);
        count += 1.0;
      }
    }
  }
  return count > 0.0 ? std::pair(sum * (1.0 / count), lengths / count)
                     : std::pair(mesh.points[point], 0.0);
}

/// Undoes moves of points that hang together with a failure: one at a bad triangle, or one that
/// went too far. So, too, where points have moved by more than an edge or so in the mean: few that
/// are astray may come from far, but then the shape around them stays.
void undoFailures(MendSurface& surface, const Incidence& trianglesAt, const std::vector<Index>& bad,
  double maxDeviation, Before& before)
{
  std::vector<Index> points;
  for (const auto& [point, at] : before)
  {
    points.push_back(point);
  }
  const auto placeOf = [&](Index point)
  {
    const auto found = std::ranges::lower_bound(points, point);
    return found != points.end() && *found == point ? static_cast<Index>(found - points.begin())
                                                    : kNone;
  };
  UnionFind groups(points.size());
  for (const Triangle& t : surface.mesh.triangles)
  {
    const std::array places{ placeOf(t[0]), placeOf(t[1]), placeOf(t[2]) };
    for (std::size_t k = 0; k < 3; ++k)
    {
      if (places[k] != kNone && places[(k + 1) % 3] != kNone)
      {
        groups.unite(places[k], places[(k + 1) % 3]);
      }
    }
  }
  std::vector<bool> failed(points.size());
  for (const Index t : bad)
  {
    for (const Index point : surface.mesh.triangles[t])
    {
      if (const Index place = placeOf(point); place != kNone)
      {
        failed[groups.root(place)] = true;
      }
    }
  }
  std::vector<double> excess(points.size(), 0.0);
  for (Index i = 0; i < points.size(); ++i)
  {
    const double shift = length(surface.mesh.points[points[i]] - before.at(points[i]));
    excess[groups.root(i)] +=
      shift - kMostShift * neighbourhood(surface.mesh, trianglesAt, points[i]).second;
    if (surface.shiftOf(points[i]) > maxDeviation)
    {
      failed[groups.root(i)] = true;
    }
  }
  for (Index i = 0; i < points.size(); ++i)
  {
    if (failed[groups.root(i)] || excess[groups.root(i)] > 0.0)
    {
      surface.mesh.points[points[i]] = before.at(points[i]);
      before.erase(points[i]);
    }
  }
}

/// The points that relaxation may move: all their triangles are in the region, none of their edges
/// is on the boundary, and the part of the region has a border that stays.
std::vector<Index> movablePoints(const TriMesh& mesh, const std::vector<std::uint8_t>& inRegion,
  const std::vector<std::uint8_t>& isOnBoundary)
{
  std::vector<std::uint8_t> isFixed(isOnBoundary);
  std::vector<std::uint8_t> isIn(mesh.points.size(), 0);
  UnionFind parts(mesh.points.size());
  for (std::size_t t = 0; t < inRegion.size(); ++t)
  {
    const auto& [a, b, c] = mesh.triangles[t];
    if (inRegion[t] != 0)
    {
      isIn[a] = isIn[b] = isIn[c] = 1;
      parts.unite(a, b);
      parts.unite(b, c);
    }
    else
    {
      isFixed[a] = isFixed[b] = isFixed[c] = 1;
    }
  }
  std::vector<std::uint8_t> hasBorder(mesh.points.size(), 0);
  for (Index p = 0; p < isIn.size(); ++p)
  {
    if (isIn[p] != 0 && isFixed[p] != 0)
    {
      hasBorder[parts.root(p)] = 1;
    }
  }
  std::vector<Index> movable;
  for (Index p = 0; p < isIn.size(); ++p)
  {
    if (isIn[p] != 0 && isFixed[p] == 0 && hasBorder[parts.root(p)] != 0)
    {
      movable.push_back(p);
    }
  }
  return movable;
}

void relax(
  TriMesh& mesh, const Incidence& trianglesAt, const std::vector<Index>& movable, int steps)
{
  std::vector<Vec3> moved(movable.size());
  for (int step = 0; step < steps; ++step)
  {
    for (std::size_t i = 0; i < movable.size(); ++i)
    {
      const Vec3 middle = neighbourhood(mesh, trianglesAt, movable[i]).first;
      moved[i] = (mesh.points[movable[i]] + middle) * 0.5;
    }
    for (std::size_t i = 0; i < movable.size(); ++i)
    {
      mesh.points[movable[i]] = moved[i];
    }
  }
}

} // namespace

std::size_t pullApart(MendSurface& surface, double maxDeviation, Execution& execution)
{
  TriMesh& mesh = surface.mesh;
  std::vector<Index> bad = trianglesOf(activeIntersections(surface, execution));
  if (bad.empty())
  {
    return 0;
  }
  const std::vector<std::uint8_t> isOnBoundary = boundaryPoints(mesh, pairEdges(mesh, execution));
  std::vector<Index> touching = touchingPoints(mesh, bad, isOnBoundary);
  if (touching.empty())
  {
    return 0;
  }
  const Incidence trianglesAt = trianglesAtPoints(mesh);
  const std::vector<Vec3> normals = vertexNormals(mesh);
  const std::vector<Vec3> start = mesh.points;
  Before before;
  for (const auto& [share, isAlongNormal] : kPulls)
  {
    for (const Index point : touching)
    {
      const Vec3& at = start[point];
      const auto [middle, edge] = neighbourhood(mesh, trianglesAt, point);
      const bool isInside = isAlongNormal && isOnBoundary[point] == 0;
      const Vec3 into = isInside ? normals[point] * -1.0 : unitVector(middle - at);
      before.emplace(point, at);
      mesh.points[point] = at + into * (share * edge);
    }
    bad = trianglesOf(activeIntersections(surface, execution));
    std::vector<Index> corners;
    for (const Index t : bad)
    {
      corners.insert(corners.end(), mesh.triangles[t].begin(), mesh.triangles[t].end());
    }
    std::ranges::sort(corners);
    std::erase_if(
      touching, [&](Index point) { return !std::ranges::binary_search(corners, point); });
  }
  undoFailures(surface, trianglesAt, bad, maxDeviation, before);
  return before.size();
}

std::size_t relaxLocally(MendSurface& surface, double maxDeviation, Execution& execution)
{
  TriMesh& mesh = surface.mesh;
  std::vector<Index> bad = trianglesOf(activeIntersections(surface, execution));
  if (bad.empty())
  {
    return 0;
  }
  const std::vector<std::uint8_t> isOnBoundary = boundaryPoints(mesh, pairEdges(mesh, execution));
  const Incidence trianglesAt = trianglesAtPoints(mesh);
  Before before;
  for (int rings = 1; rings <= kMostRings && !bad.empty(); ++rings)
  {
    const std::vector<Index> movable = movablePoints(
      mesh, withRings(mesh, bad, static_cast<std::size_t>(rings), execution), isOnBoundary);
    for (const Index point : movable)
    {
      before.emplace(point, mesh.points[point]);
    }
    relax(mesh, trianglesAt, movable, kSteps * rings);
    bad = trianglesOf(activeIntersections(surface, execution));
  }
  undoFailures(surface, trianglesAt, bad, maxDeviation, before);
  return before.size();
}

} // namespace scan
