// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/hole_choice.h"

#include "filters/base/error.h"
#include "filters/geometry/holes.h"
#include "filters/geometry/local_plane.h"
#include "filters/geometry/point_triangle.h"

#include <algorithm>
#include <limits>
#include <string>

namespace scan
{
namespace
{

/// The loop whose rim is nearest to a place.
std::size_t nearestLoop(const TriMesh& mesh, const std::vector<BoundaryLoop>& loops, const Vec3& at)
{
  std::size_t nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < loops.size(); ++i)
  {
    const auto& points = loops[i].points;
    for (std::size_t k = 0; k < points.size(); ++k)
    {
      const Vec3& a = mesh.points[points[k]];
      const Vec3& b = mesh.points[points[(k + 1) % points.size()]];
      const double distance = squaredDistance(at, a, b, b);
      if (distance < least)
      {
        least = distance;
        nearest = i;
      }
    }
  }
  return nearest;
}

/// The whole loop, the way that a patch runs.
HolePolygon polygonOf(const BoundaryLoop& loop)
{
  HolePolygon polygon{ { loop.points.rbegin(), loop.points.rend() }, {} };
  for (std::size_t i = loop.halves.size() - 1; i-- > 0;)
  {
    polygon.beyond.push_back(loop.halves[i] / 3);
  }
  polygon.beyond.push_back(loop.halves.back() / 3);
  return polygon;
}

struct RimPlace
{
  std::size_t loop = 0;
  std::size_t corner = 0;
};

/// The point of a rim that is nearest to a place.
RimPlace nearestRimPoint(
  const TriMesh& mesh, const std::vector<BoundaryLoop>& loops, const Vec3& at)
{
  RimPlace place;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < loops.size(); ++i)
  {
    for (std::size_t k = 0; k < loops[i].points.size(); ++k)
    {
      const Vec3 d = mesh.points[loops[i].points[k]] - at;
      if (dot(d, d) < least)
      {
        least = dot(d, d);
        place = { i, k };
      }
    }
  }
  return place;
}

/// The length of a loop from one corner on to another.
double lengthBetween(
  const TriMesh& mesh, const BoundaryLoop& loop, std::size_t from, std::size_t to)
{
  double sum = 0.0;
  const std::size_t count = loop.points.size();
  for (std::size_t k = from; k != to; k = (k + 1) % count)
  {
    sum += length(mesh.points[loop.points[(k + 1) % count]] - mesh.points[loop.points[k]]);
  }
  return sum;
}

/// Asks for the part of one hole only.
void choosePart(const TriMesh& mesh, const std::vector<BoundaryLoop>& loops, const RimPart& part,
  HoleChoice& choice)
{
  RimPlace from = nearestRimPoint(mesh, loops, part.from);
  RimPlace to = nearestRimPoint(mesh, loops, part.to);
  if (from.loop != to.loop)
  {
    throw Error(ErrorCode::badParameter,
      "the places to fill between are at different holes; name two of one rim, or bridge them");
  }
  const BoundaryLoop& loop = loops[from.loop];
  const double there = lengthBetween(mesh, loop, from.corner, to.corner);
  if (loop.isManifold && there > loop.length - there)
  {
    std::swap(from, to);
  }
  const std::size_t count = loop.points.size();
  const std::size_t edges = (to.corner + count - from.corner) % count;
  if (edges < 2)
  {
    throw Error(ErrorCode::badParameter,
      "there is nothing to fill between these places; name two that are farther apart on the rim");
  }
  HolePolygon polygon;
  for (std::size_t i = edges + 1; i-- > 0;)
  {
    const std::size_t corner = (from.corner + i) % count;
    polygon.points.push_back(loop.points[corner]);
    polygon.beyond.push_back(i > 0 ? loop.halves[(corner + count - 1) % count] / 3 : kNone);
  }
  for (Hole& hole : choice.holes)
  {
    hole.fate = hole.fate == HoleFate::filled ? HoleFate::notAsked : hole.fate;
  }
  Hole& hole = choice.holes[from.loop];
  if (hole.fate == HoleFate::notAsked)
  {
    hole.fate = HoleFate::filled;
    hole.edges = static_cast<Index>(edges);
    hole.length = lengthBetween(mesh, loop, from.corner, to.corner) +
      length(mesh.points[loop.points[to.corner]] - mesh.points[loop.points[from.corner]]);
    Vec3 sum;
    for (const Index point : polygon.points)
    {
      sum = sum + mesh.points[point];
    }
    hole.place = sum * (1.0 / static_cast<double>(polygon.points.size()));
    choice.polygons[from.loop] = std::move(polygon);
  }
}

/// Why a loop cannot or shall not be filled, leaving aside which are asked for.
HoleFate fateOf(
  const BoundaryLoop& loop, std::span<const std::uint8_t> inRegion, const FillHolesOptions& options)
{
  const auto isInside = [&](Index point) { return inRegion[point] != 0; };
  return !loop.isManifold                                              ? HoleFate::notManifold
    : !std::ranges::all_of(loop.points, isInside)                      ? HoleFate::outsideRegion
    : options.part                                                     ? HoleFate::filled
    : options.maxPerimeter > 0.0 && loop.length > options.maxPerimeter ? HoleFate::tooLong
    : options.maxEdges > 0 && loop.points.size() > options.maxEdges    ? HoleFate::tooManyEdges
                                                                       : HoleFate::filled;
}

bool isKeptRim(const BoundaryLoop& loop, OuterRims rims)
{
  return rims == OuterRims::keep ? loop.isLongest
                                 : rims == OuterRims::automatic && isOuterRim(loop);
}

} // namespace

HoleChoice chooseHoles(const TriMesh& mesh, std::span<const std::uint8_t> inRegion,
  const FillHolesOptions& options, Execution& execution)
{
  const std::vector<BoundaryLoop> loops = boundaryLoops(mesh, execution);
  if (loops.empty() && (options.part || !options.at.empty()))
  {
    throw Error(ErrorCode::badParameter, "the surface has no holes");
  }
  std::vector<std::uint8_t> isAsked(loops.size(), options.at.empty() ? 1 : 0);
  for (const Vec3& at : options.at)
  {
    isAsked[nearestLoop(mesh, loops, at)] = 1;
  }
  HoleChoice choice;
  choice.polygons.resize(loops.size());
  for (std::size_t i = 0; i < loops.size(); ++i)
  {
    const BoundaryLoop& loop = loops[i];
    HoleFate fate = fateOf(loop, inRegion, options);
    if (fate == HoleFate::filled && !options.part)
    {
      fate = isAsked[i] == 0                                       ? HoleFate::notAsked
        : options.at.empty() && isKeptRim(loop, options.outerRims) ? HoleFate::outerRim
                                                                   : HoleFate::filled;
    }
    choice.holes.push_back(
      { loop.place, loop.length, static_cast<Index>(loop.points.size()), fate });
    if (fate == HoleFate::filled && !options.part)
    {
      choice.polygons[i] = polygonOf(loop);
    }
  }
  if (options.part)
  {
    choosePart(mesh, loops, *options.part, choice);
  }
  return choice;
}

} // namespace scan
