// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/shells.h"

#include "filters/geometry/union_find.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace scan
{
namespace
{

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

/// A point of a shell that faces inwards, inside a triangle: where shells touch, it is mostly at
/// corners and edges.
struct Probe
{
  Vec3 point;
  Index shell;
};

/// Six times the volume between a triangle and a point.
double sixVolumes(const TriMesh& mesh, const Triangle& triangle, const Vec3& from)
{
  const auto& [a, b, c] = triangle;
  return dot(mesh.points[a] - from, cross(mesh.points[b] - from, mesh.points[c] - from));
}

/// How often, and which way, a triangle winds around a point seen along z: 1, -1 or 0. A point on
/// an edge counts as moved a little, the same way for all triangles at the edge.
int windingAlongZ(const std::array<Vec3, 3>& corners, const Vec3& point)
{
  const auto flat = [](const Vec3& p) { return Kernel::Point_2(p.x, p.y); };
  int winding = 0;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Vec3& from = corners[k];
    const Vec3& to = corners[(k + 1) % 3];
    const bool isUpwards = from.y <= point.y && to.y > point.y;
    const bool isDownwards = from.y > point.y && to.y <= point.y;
    if (isUpwards || isDownwards)
    {
      const CGAL::Orientation side = CGAL::orientation(flat(from), flat(to), flat(point));
      winding += isUpwards && side == CGAL::LEFT_TURN ? 1 : 0;
      winding -= isDownwards && side == CGAL::RIGHT_TURN ? 1 : 0;
    }
  }
  return winding;
}

/// Whether the point is below the plane of a triangle that winds around it.
bool isBelow(const std::array<Vec3, 3>& corners, const Vec3& point, int winding)
{
  const auto exact = [](const Vec3& p) { return Kernel::Point_3(p.x, p.y, p.z); };
  const CGAL::Orientation side =
    CGAL::orientation(exact(corners[0]), exact(corners[1]), exact(corners[2]), exact(point));
  return side == (winding > 0 ? CGAL::NEGATIVE : CGAL::POSITIVE);
}

std::vector<Probe> probesOf(const TriMesh& mesh, const Shells& shells)
{
  std::vector<Probe> probes;
  for (Index number = 0; number < shells.shells.size(); ++number)
  {
    const Shell& shell = shells.shells[number];
    if (shell.volume < 0.0)
    {
      const auto& [a, b, c] = mesh.triangles[shell.firstTriangle];
      const Vec3 middle = (mesh.points[a] + mesh.points[b] + mesh.points[c]) * (1.0 / 3.0);
      probes.push_back({ middle, number });
    }
  }
  std::ranges::sort(probes, {}, [](const Probe& probe) { return probe.point.x; });
  return probes;
}

} // namespace

Shells findShells(const TriMesh& mesh, std::span<const Index> mate)
{
  UnionFind sets(mesh.triangles.size());
  for (std::size_t half = 0; half < mate.size(); ++half)
  {
    if (mate[half] != kNone)
    {
      const Index here = sets.root(static_cast<Index>(half / 3));
      const Index there = sets.root(mate[half] / 3);
      if (here != there)
      {
        sets.join(std::min(here, there), std::max(here, there));
      }
    }
  }
  Shells result;
  result.shellOf.resize(mesh.triangles.size());
  for (Index t = 0; t < mesh.triangles.size(); ++t)
  {
    const Index root = sets.root(t); // the first triangle of the shell
    if (root == t)
    {
      result.shellOf[t] = static_cast<Index>(result.shells.size());
      result.shells.push_back({ .firstTriangle = t, .isClosed = true });
    }
    result.shellOf[t] = result.shellOf[root];
    Shell& shell = result.shells[result.shellOf[t]];
    const Vec3& from = mesh.points[mesh.triangles[root][0]];
    ++shell.triangles;
    shell.volume += sixVolumes(mesh, mesh.triangles[t], from) / 6.0;
    for (std::size_t k = 0; k < 3; ++k)
    {
      shell.isClosed = shell.isClosed && mate[3 * std::size_t{ t } + k] != kNone;
    }
  }
  for (Shell& shell : result.shells)
  {
    shell.volume = shell.isClosed ? shell.volume : 0.0;
  }
  return result;
}

void findContainers(const TriMesh& mesh, Shells& shells, Execution& execution)
{
  const std::vector<Probe> probes = probesOf(mesh, shells);
  std::map<std::pair<Index, Index>, int> windings; // of a container around a shell
  for (std::size_t t = 0; t < mesh.triangles.size() && !probes.empty(); ++t)
  {
    constexpr std::size_t kStep = std::size_t{ 1 } << 16U;
    if (t % kStep == 0)
    {
      execution.step("shells", t, mesh.triangles.size());
    }
    if (shells.shells[shells.shellOf[t]].volume <= 0.0)
    {
      continue;
    }
    const auto& [a, b, c] = mesh.triangles[t];
    const std::array<Vec3, 3> corners = { mesh.points[a], mesh.points[b], mesh.points[c] };
    const auto [low, high] = std::minmax({ corners[0].x, corners[1].x, corners[2].x });
    auto probe =
      std::ranges::lower_bound(probes, low, {}, [](const Probe& p) { return p.point.x; });
    for (; probe != probes.end() && probe->point.x <= high; ++probe)
    {
      const int winding = windingAlongZ(corners, probe->point);
      if (winding != 0 && isBelow(corners, probe->point, winding))
      {
        windings[{ probe->shell, shells.shellOf[t] }] += winding;
      }
    }
  }
  for (const auto& [pair, winding] : windings)
  {
    Shell& hollow = shells.shells[pair.first];
    const bool isSmaller = hollow.container == kNone ||
      shells.shells[pair.second].volume < shells.shells[hollow.container].volume;
    hollow.container = winding != 0 && isSmaller ? pair.second : hollow.container;
  }
}

} // namespace scan
