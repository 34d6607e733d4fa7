// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/relax.h"

#include "filters/base/error.h"
#include "filters/geometry/bounding_box.h"
#include "filters/geometry/feature_lines.h"
#include "filters/geometry/finite_points.h"
#include "filters/geometry/guided_filter.h"
#include "filters/geometry/half_edges.h"
#include "filters/geometry/local_plane.h"
#include "filters/geometry/ordered_mesh.h"
#include "filters/geometry/umbrella_steps.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace scan
{
namespace
{

void requireWeights(const RelaxOptions& options)
{
  if (!(options.lambda > 0.0) || options.lambda > 1.0)
  {
    throw Error(ErrorCode::badParameter, "lambda must be above 0 and at most 1");
  }
  if (!(options.mu < -options.lambda) || options.mu < -1.1)
  {
    throw Error(ErrorCode::badParameter,
      "mu must be a little below -lambda, such as -0.705 for 0.7, and at least -1.1");
  }
  if ((1.0 - 2.0 * options.lambda) * (1.0 - 2.0 * options.mu) < -1.0)
  {
    throw Error(ErrorCode::badParameter,
      "these weights would magnify what alternates from point to point; take smaller ones, at most "
      "0.7 and -0.705");
  }
}

void requireUsablePoints(const TriMesh& mesh)
{
  requireFinitePoints(mesh.points);
  constexpr double kLargest = 1e70; // squares of areas are computed
  if (!(BoundingBox(mesh.points).diagonal() < kLargest))
  {
    throw Error(ErrorCode::badInput, "the points are too far apart; scale the model down");
  }
}

/// Which points may move, towards which.
struct Freedom
{
  PointLists neighbours;
  std::vector<std::uint8_t> isMovable;
  std::vector<std::uint8_t> isSharp; ///< on a boundary or a feature line
};

/// The points of the closed piece or the rim of a hole that a point is of, if they are few: as all
/// of it is noise, it would shrink to a point.
std::vector<Index> tinyPiece(const PointLinks& links, Index point)
{
  constexpr std::size_t kFewest = 12;
  std::vector<Index> found{ point };
  for (std::size_t next = 0; next < found.size(); ++next)
  {
    for (const Index other : links.neighbours.of(found[next]))
    {
      if (std::ranges::find(found, other) == found.end())
      {
        found.push_back(other);
      }
      if (found.size() == kFewest)
      {
        return {};
      }
    }
  }
  return found;
}

void fixTinyPieces(const PointLinks& links, std::vector<std::uint8_t>& isMovable)
{
  constexpr std::size_t kMany = 4; // no closed piece of fewer than 12 points has more around each
  for (std::size_t i = 0; i < isMovable.size(); ++i)
  {
    if (isMovable[i] != 0 && links.neighbours.of(i).size() <= kMany)
    {
      for (const Index point : tinyPiece(links, static_cast<Index>(i)))
      {
        isMovable[point] = 0;
      }
    }
  }
}

Freedom freedomOf(const PointLinks& links, std::span<const std::uint8_t> inRegion,
  const RelaxOptions& options, Execution& execution)
{
  Freedom freedom;
  const std::size_t points = links.kinds.size();
  freedom.isMovable.resize(points);
  freedom.isSharp.resize(points);
  for (std::size_t i = 0; i < points; ++i)
  {
    const bool isFree = links.kinds[i] == PointKind::inner ||
      (links.kinds[i] == PointKind::boundary && options.boundary == RelaxOptions::Boundary::relax);
    freedom.isMovable[i] = isFree && inRegion[i] != 0 ? 1 : 0;
    freedom.isSharp[i] = links.kinds[i] == PointKind::inner ? 0 : 1;
  }
  fixTinyPieces(links, freedom.isMovable);
  freedom.neighbours = makeLists(
    points, execution,
    [&](std::size_t i)
    { return freedom.isMovable[i] != 0 ? static_cast<Index>(links.neighbours.of(i).size()) : 0; },
    [&](std::size_t i, std::span<Index> list)
    { std::copy_n(links.neighbours.of(i).data(), list.size(), list.data()); });
  return freedom;
}

/// Points on a feature line may move along it only, corners not at all.
void bindToLines(Freedom& freedom, const FeatureLines& lines, Execution& execution)
{
  const auto allowed = [&](std::size_t i) -> std::span<const Index>
  {
    const auto along = lines.along.of(i);
    const auto near = freedom.neighbours.of(i);
    const bool isFree = along.empty() || near.size() <= 2; // which is on a boundary
    return isFree || near.empty() ? near : along.size() == 2 ? along : std::span<const Index>{};
  };
  PointLists bound = makeLists(
    freedom.isMovable.size(), execution,
    [&](std::size_t i) { return static_cast<Index>(allowed(i).size()); },
    [&](std::size_t i, std::span<Index> list)
    { std::copy_n(allowed(i).data(), list.size(), list.data()); });
  freedom.neighbours = std::move(bound);
  for (std::size_t i = 0; i < freedom.isSharp.size(); ++i)
  {
    freedom.isSharp[i] = freedom.isSharp[i] != 0 || !lines.along.of(i).empty() ? 1 : 0;
  }
}

/// Six times the volume below triangles, seen from the first point.
double volumeOf(std::span<const Vec3> points, const std::vector<Triangle>& triangles)
{
  double sum = 0.0;
  for (const auto& [a, b, c] : triangles)
  {
    const Vec3 from = points[0];
    sum += dot(points[a] - from, cross(points[b] - from, points[c] - from));
  }
  return sum / 6.0;
}

/// Where the points are afterwards; the counts of features, too.
RelaxResult movedPoints(const TriMesh& mesh, std::span<const std::uint8_t> inRegion,
  const RelaxOptions& options, Execution& execution)
{
  RelaxResult result;
  const PointLinks links = linkPoints(mesh, execution);
  Freedom freedom = freedomOf(links, inRegion, options, execution);
  const UmbrellaSteps steps{ options.iterations, options.lambda, options.mu, options.maxDeviation };
  if (options.featureAngle > 0.0)
  {
    const double angle = options.featureAngle * std::numbers::pi / 180.0;
    GuidedResult cleaned = guidedFilter(mesh, links.triangles, freedom.isMovable,
      { .angle = angle, .limit = options.maxDeviation }, "features", execution);
    const FeatureLines lines = findFeatureLines(mesh, cleaned.normals, angle, execution);
    bindToLines(freedom, lines, execution);
    result.featureEdges = lines.edges;
    result.featureCorners = lines.corners;
    const TriMesh sharp{ std::move(cleaned.points), mesh.triangles };
    result.points =
      umbrellaSteps({ sharp, links.triangles, freedom.neighbours, freedom.isSharp, mesh.points },
        steps, "relax", execution);
  }
  else
  {
    result.points =
      umbrellaSteps({ mesh, links.triangles, freedom.neighbours, freedom.isSharp, mesh.points },
        steps, "relax", execution);
  }
  if (links.isClosed)
  {
    result.volumeBefore = volumeOf(mesh.points, mesh.triangles);
    result.volumeAfter = volumeOf(result.points, mesh.triangles);
  }
  return result;
}

/// The same with points and triangles in an order that caches like.
RelaxResult movedInOrder(const TriMesh& mesh, std::span<const std::uint8_t> inRegion,
  const RelaxOptions& options, Execution& execution)
{
  const OrderedMesh ordered = orderedMesh(mesh, execution);
  std::vector<std::uint8_t> orderedRegion(inRegion.size());
  std::ranges::transform(
    ordered.pointNames, orderedRegion.begin(), [&](Index name) { return inRegion[name]; });
  RelaxResult result = movedPoints(ordered.mesh, orderedRegion, options, execution);
  std::vector<Vec3> points(mesh.points.size());
  std::ranges::transform(
    ordered.numbers, points.begin(), [&](Index number) { return result.points[number]; });
  result.points = std::move(points);
  return result;
}

void countShifts(RelaxResult& result, const TriMesh& mesh, std::span<const std::uint8_t> inRegion,
  double maxDeviation)
{
  constexpr double kAtLimit = 1.0 - 1e-5;
  double sum = 0.0;
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
  {
    const double shift = length(result.points[i] - mesh.points[i]);
    sum += shift;
    result.moved += result.points[i] != mesh.points[i] ? 1 : 0;
    result.limited += shift > 0.0 && shift >= maxDeviation * kAtLimit ? 1 : 0;
    result.largestShift = std::max(result.largestShift, shift);
  }
  const auto members = std::accumulate(inRegion.begin(), inRegion.end(), std::size_t{ 0 });
  result.meanShift = members > 0 ? sum / static_cast<double>(members) : 0.0;
}

} // namespace

RelaxResult relax(const TriMesh& mesh, std::span<const std::uint8_t> inRegion,
  const RelaxOptions& options, Execution& execution)
{
  requireWeights(options);
  requireCorners(mesh);
  requireUsablePoints(mesh);
  execution.step(options.featureAngle > 0.0 ? "features" : "relax", 0, 1);
  RelaxResult result = isScattered(mesh) ? movedInOrder(mesh, inRegion, options, execution)
                                         : movedPoints(mesh, inRegion, options, execution);
  countShifts(result, mesh, inRegion, options.maxDeviation);
  execution.step("relax", 1, 1);
  return result;
}

} // namespace scan
