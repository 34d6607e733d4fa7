// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/spikes.h"

#include "filters/geometry/collect.h"
#include "filters/geometry/half_edges.h"
#include "filters/geometry/local_plane.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace scan
{
namespace
{

constexpr std::size_t kMostNeighbours = 64; // more are no spike but the pole of a fan
constexpr double kSteep = 0.7071;           // cosine of the turn beyond the ring

/// The points around a point in their order, none where they are no closed ring.
std::vector<Index> ringAround(const TriMesh& mesh, const Incidence& trianglesAt, Index point)
{
  std::vector<Segment> sides;
  for (const Index t : trianglesAt.of(point))
  {
    const Triangle& corners = mesh.triangles[t];
    const auto k = static_cast<std::size_t>(std::ranges::find(corners, point) - corners.begin());
    sides.push_back({ corners[(k + 1) % 3], corners[(k + 2) % 3] });
  }
  if (sides.size() < 3 || sides.size() > kMostNeighbours)
  {
    return {};
  }
  std::ranges::sort(sides); // the ring starts the same way however triangles are numbered
  std::vector<Index> ring{ sides[0][0] };
  Index next = sides[0][1];
  std::swap(sides[0], sides.back());
  sides.pop_back();
  while (next != ring.front())
  {
    ring.push_back(next);
    const auto side =
      std::ranges::find_if(sides, [&](const Segment& s) { return s[0] == next || s[1] == next; });
    if (side == sides.end())
    {
      return {};
    }
    next = (*side)[0] == next ? (*side)[1] : (*side)[0];
    std::swap(*side, sides.back());
    sides.pop_back();
  }
  return sides.empty() ? ring : std::vector<Index>{};
}

/// The normal of the triangle a b c, of length 1, when it has one.
Vec3 normalOf(const Vec3& a, const Vec3& b, const Vec3& c)
{
  return unitVector(cross(b - a, c - a));
}

/// Whether the surface turns by more than 45 degrees at the side a b of the ring.
bool turnsAway(const TriMesh& mesh, const Incidence& trianglesAt, Index point, Index a, Index b)
{
  const std::vector<Vec3>& at = mesh.points;
  for (const Index t : trianglesAt.of(a))
  {
    const Triangle& corners = mesh.triangles[t];
    if (std::ranges::count(corners, b) == 0 || std::ranges::count(corners, point) > 0)
    {
      continue;
    }
    const Index beyond =
      *std::ranges::find_if(corners, [&](Index corner) { return corner != a && corner != b; });
    return dot(normalOf(at[a], at[b], at[point]), normalOf(at[b], at[a], at[beyond])) < kSteep;
  }
  return false;
}

} // namespace

Incidence trianglesAtPoints(const TriMesh& mesh)
{
  return { mesh.points.size(), mesh.triangles.size(),
    [&](std::size_t t, auto&& visit)
    {
      if (!isCollapsed(mesh.triangles[t]))
      {
        std::ranges::for_each(mesh.triangles[t], visit);
      }
    } };
}

std::optional<Spike> spikeAt(
  const TriMesh& mesh, const Incidence& trianglesAt, Index point, double ratio)
{
  const std::vector<Index> ring = ringAround(mesh, trianglesAt, point);
  if (ring.empty())
  {
    return std::nullopt;
  }
  const auto count = static_cast<double>(ring.size());
  Vec3 middle;
  for (const Index p : ring)
  {
    middle = middle + mesh.points[p] * (1.0 / count);
  }
  Vec3 normal;
  double radius = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i)
  {
    const Vec3 out = mesh.points[ring[i]] - middle;
    normal = normal + cross(out, mesh.points[ring[(i + 1) % ring.size()]] - middle);
    radius += length(out) / count;
  }
  const double height = std::abs(dot(mesh.points[point] - middle, unitVector(normal)));
  if (!(height > ratio * radius))
  {
    return std::nullopt;
  }
  std::size_t steep = 0;
  for (std::size_t i = 0; i < ring.size(); ++i)
  {
    steep += turnsAway(mesh, trianglesAt, point, ring[i], ring[(i + 1) % ring.size()]) ? 1 : 0;
  }
  return 2 * steep >= ring.size() ? std::optional(Spike{ point, middle, height }) : std::nullopt;
}

std::vector<Spike> findSpikes(
  const TriMesh& mesh, const Incidence& trianglesAt, double ratio, Execution& execution)
{
  return collect<Spike>(static_cast<Index>(mesh.points.size()), execution,
    [&](Index point, std::vector<Spike>& found)
    {
      if (const auto spike = spikeAt(mesh, trianglesAt, point, ratio))
      {
        found.push_back(*spike);
      }
    });
}

} // namespace scan
