// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/loop_rules.h"

#include "filters/geometry/local_plane.h"

#include <array>
#include <cmath>
#include <numbers>

namespace scan
{
namespace
{

/// How far a point with so many neighbours moves towards their mean.
double loopShare(std::size_t neighbours)
{
  const auto share = [](std::size_t m)
  {
    const double term = 3.0 + 2.0 * std::cos(2.0 * std::numbers::pi / static_cast<double>(m));
    return (40.0 - term * term) / 64.0;
  };
  static const auto table = [&]
  {
    std::array<double, 32> shares{};
    for (std::size_t m = 1; m < shares.size(); ++m)
    {
      shares.at(m) = share(m);
    }
    return shares;
  }();
  return neighbours < table.size() ? table[neighbours] : share(neighbours);
}

bool bends(const TriMesh& mesh, Index half, Index mate, double cosine)
{
  const Vec3& u = mesh.points[originOf(mesh, half)];
  const Vec3 axis = mesh.points[originOf(mesh, nextHalf(half))] - u;
  const Vec3 first = cross(axis, mesh.points[originOf(mesh, previousHalf(half))] - u);
  const Vec3 second = cross(mesh.points[originOf(mesh, previousHalf(mate))] - u, axis);
  return dot(first, second) < cosine * length(first) * length(second);
}

} // namespace

std::vector<std::uint8_t> creasesOf(
  const TriMesh& mesh, const EdgeFans& fans, double degrees, Execution& execution)
{
  std::vector<std::uint8_t> creases;
  if (degrees >= 180.0)
  {
    return creases;
  }
  creases.resize(mesh.triangles.size(), 0);
  const double cosine = std::cos(degrees * std::numbers::pi / 180.0);
  execution.parallelFor(creases.size(), 4096,
    [&](std::size_t begin, std::size_t end)
    {
      for (auto half = static_cast<Index>(3 * begin); half < 3 * end; ++half)
      {
        // of two half-edges the smaller one decides, so that rounding cannot make them differ
        const Index mate = fans.mate(half);
        if (mate != kNone && bends(mesh, std::min(half, mate), std::max(half, mate), cosine))
        {
          creases[half / 3] |= static_cast<std::uint8_t>(1U << half % 3);
        }
      }
    });
  return creases;
}

LoopRules::LoopRules(const TriMesh& mesh, const EdgeFans& fans,
  std::span<const std::uint8_t> isChosen, std::span<const std::uint8_t> creases)
  : Mesh(mesh)
  , Fans(fans)
  , IsChosen(isChosen)
  , Creases(creases)
  , Corners(mesh.points.size())
{
  for (Index t = 0; t < mesh.triangles.size(); ++t)
  {
    if (isCollapsed(mesh.triangles[t]))
    {
      continue;
    }
    for (Index k = 0; k < 3; ++k)
    {
      Corner& corner = this->Corners[mesh.triangles[t][k]];
      if (isChosen[t] == 0 || corner.triangles == kNone)
      {
        corner.triangles = kNone;
        continue;
      }
      corner.half = corner.triangles == 0 ? 3 * t + k : corner.half;
      ++corner.triangles;
    }
  }
}

/// The neighbours of a point along one fan of triangles.
struct LoopRules::Ring
{
  Index neighbours = 0;
  Index triangles = 0;
  Index sharp = 0; ///< neighbours along boundaries and creases
  Vec3 sum;
  Vec3 sharpSum;

  void add(const Vec3& neighbour, bool isSharp)
  {
    ++this->neighbours;
    this->sum = this->sum + neighbour;
    if (isSharp)
    {
      ++this->sharp;
      this->sharpSum = this->sharpSum + neighbour;
    }
  }
};

/// Goes around the point, whatever way triangles face, beginning with the edge of `half`, which
/// has it at one end and `neighbour` at the other. Adds the neighbours. Returns false at an edge
/// that has not two triangles, else true when it is back.
bool LoopRules::turn(Index point, Index half, Index neighbour, Ring& ring) const
{
  Index edge = half;
  do
  {
    const Index mate = this->Fans.mate(edge);
    ring.add(this->Mesh.points[neighbour], mate == kNone || this->isCrease(edge));
    if (mate == kNone)
    {
      return false;
    }
    ++ring.triangles;
    const HalfCorners corners = cornersOf(this->Mesh, mate);
    neighbour = corners.across;
    edge = corners.from == point ? previousHalf(mate) : nextHalf(mate);
  } while (edge != half);
  return true;
}

LoopRules::Ring LoopRules::ringOf(Index point) const
{
  Ring ring;
  const Index half = this->Corners[point].half;
  const HalfCorners corners = cornersOf(this->Mesh, half);
  if (!this->turn(point, previousHalf(half), corners.across, ring))
  {
    this->turn(point, half, corners.to, ring);
    ++ring.triangles; // where both turns began
  }
  return ring;
}

Vec3 LoopRules::pointAt(Index point) const
{
  const Vec3& at = this->Mesh.points[point];
  const Corner& corner = this->Corners[point];
  if (corner.triangles == kNone || corner.triangles == 0)
  {
    return at;
  }
  const Ring ring = this->ringOf(point);
  if (ring.triangles != corner.triangles || ring.sharp > 2)
  {
    return at;
  }
  if (ring.sharp == 2)
  {
    return at * 0.75 + ring.sharpSum * 0.125;
  }
  const double share = loopShare(ring.neighbours);
  return at * (1.0 - share) + ring.sum * (share / ring.neighbours);
}

Vec3 LoopRules::middleAt(Index half) const
{
  const auto& points = this->Mesh.points;
  const HalfCorners corners = cornersOf(this->Mesh, half);
  const Vec3 ends = points[corners.from] + points[corners.to];
  const Index mate = this->Fans.mate(half);
  if (mate == kNone || this->isCrease(half) || this->IsChosen[half / 3] == 0 ||
    this->IsChosen[mate / 3] == 0)
  {
    return ends * 0.5;
  }
  return ends * 0.375 +
    (points[corners.across] + points[cornersOf(this->Mesh, mate).across]) * 0.125;
}

} // namespace scan
