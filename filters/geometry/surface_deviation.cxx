// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/surface_deviation.h"

#include "filters/base/error.h"
#include "filters/geometry/bounding_box.h"
#include "filters/geometry/collect.h"
#include "filters/geometry/deviation_bound.h"
#include "filters/geometry/finite_points.h"
#include "filters/geometry/half_edges.h"
#include "filters/geometry/hilbert_order.h"
#include "filters/geometry/local_plane.h"
#include "filters/geometry/neighbours.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <string>

namespace scan
{
namespace
{

constexpr const char* kPhase = "deviation";

Vec3 middleOf(const CornerPlaces& t)
{
  constexpr double kThird = 1.0 / 3.0; // of each, as the sum may overflow
  return t[0] * kThird + t[1] * kThird + t[2] * kThird;
}

/// The triangles along a curve through their middles.
std::vector<Index> curveOrder(const TriMesh& mesh, Execution& execution)
{
  std::vector<Vec3> middles(mesh.triangles.size());
  for (Index t = 0; t < middles.size(); ++t)
  {
    middles[t] = middleOf(cornerPlaces(mesh, t));
  }
  return hilbertOrder(middles, execution);
}

void requireSurfaces(const TriMesh& from, const TriangleTree& to)
{
  requireCorners(from);
  if (to.mesh().triangles.empty())
  {
    throw Error(
      ErrorCode::badInput, "a surface without triangles is at no distance; give one that has some");
  }
  for (const Triangle& triangle : from.triangles)
  {
    for (const Index corner : triangle)
    {
      if (!isFinite(from.points[corner]))
      {
        throw Error(ErrorCode::badInput,
          "point " + std::to_string(corner) + " is not finite; mend the surface first");
      }
    }
  }
}

/// Who meets whom at the edges of a surface, where it is worth the time.
std::vector<Index> matesFor(const TriMesh& from, const TriMesh& to, Execution& execution)
{
  return 16 * from.triangles.size() > to.triangles.size() ? pairEdges(to, execution).mate
                                                          : std::vector<Index>{};
}

/// Groups of triangles that follow each other along the curve: questions near each other.
constexpr std::size_t kGroup = 16;
constexpr std::size_t kGroupsInTask = 64;

/// Calls look(t, near) for all triangles, in groups; `near` is around the group.
template <class Look>
void lookInGroups(const TriMesh& from, std::span<const Index> order, const TriangleTree& to,
  const LoopOfPhase& loop, Execution& execution, Look&& look)
{
  parallelSteps(
    execution, loop, (order.size() + kGroup - 1) / kGroup,
    [&](std::size_t begin, std::size_t end)
    {
      TrianglesNear near(to);
      Index hint = kNone;
      for (std::size_t group = begin; group < end; ++group)
      {
        const auto members =
          order.subspan(kGroup * group, std::min(kGroup, order.size() - kGroup * group));
        std::array<Vec3, 3 * kGroup> corners;
        std::size_t count = 0;
        for (const Index t : members)
        {
          for (const Vec3& corner : cornerPlaces(from, t))
          {
            corners[count++] = corner;
          }
        }
        const BoundingBox box({ corners.data(), count });
        const SurfacePlace place = to.nearest(corners[0], hint);
        constexpr double kMargin = 0.25; // of the box: most are as near as the first and some
        near.moveTo(
          { box.low, box.high }, 1.5 * std::sqrt(place.squaredDistance) + kMargin * box.diagonal());
        hint = place.triangle;
        for (const Index t : members)
        {
          look(t, near, hint);
        }
      }
    },
    kGroupsInTask);
}

/// Distances at the points and in the middles of triangles.
struct Samples
{
  std::vector<double> ofPoints;
  std::vector<double> ofMiddles;
  std::vector<Index> nearest; // to the middles
};

Samples sample(
  const TriMesh& from, std::span<const Index> order, const TriangleTree& to, Execution& execution)
{
  Samples samples;
  samples.ofPoints.resize(from.points.size());
  samples.ofMiddles.resize(from.triangles.size());
  samples.nearest.resize(from.triangles.size());
  std::vector<Index> firstOf(from.points.size(), kNone); // the triangle that looks at the point
  for (const Index t : order)
  {
    for (const Index corner : from.triangles[t])
    {
      firstOf[corner] = firstOf[corner] == kNone ? t : firstOf[corner];
    }
  }
  lookInGroups(from, order, to, { kPhase, 0, 2 }, execution,
    [&](Index t, const TrianglesNear& near, Index& hint)
    {
      for (const Index corner : from.triangles[t])
      {
        if (firstOf[corner] == t)
        {
          const SurfacePlace place = near.nearest(from.points[corner], hint);
          samples.ofPoints[corner] = std::sqrt(place.squaredDistance);
          hint = place.triangle;
        }
      }
      const SurfacePlace place = near.nearest(middleOf(cornerPlaces(from, t)), hint);
      samples.ofMiddles[t] = std::sqrt(place.squaredDistance);
      samples.nearest[t] = place.triangle;
      hint = place.triangle;
    });
  return samples;
}

/// The largest distance of a triangle that was found.
DeviationBounds knownOf(const TriMesh& from, const Samples& samples, Index t)
{
  DeviationBounds known{ samples.ofMiddles[t], 0.0, middleOf(cornerPlaces(from, t)) };
  for (const Index corner : from.triangles[t])
  {
    if (samples.ofPoints[corner] > known.atLeast)
    {
      known.atLeast = samples.ofPoints[corner];
      known.where = from.points[corner];
    }
  }
  return known;
}

/// Means over the area, exact where distances change linearly and squares as a square does; and the
/// largest.
SurfaceDeviation summary(const TriMesh& from, const Samples& samples)
{
  double area = 0.0;
  double sum = 0.0;
  double squares = 0.0;
  SurfaceDeviation result;
  result.where = middleOf(cornerPlaces(from, 0));
  for (Index t = 0; t < from.triangles.size(); ++t)
  {
    const CornerPlaces corners = cornerPlaces(from, t);
    const double weight = length(cross(corners[1] - corners[0], corners[2] - corners[0]));
    const double middle = samples.ofMiddles[t];
    double ofCorners = 0.0;
    double squaresOfCorners = 0.0;
    for (const Index corner : from.triangles[t])
    {
      const double distance = samples.ofPoints[corner];
      ofCorners += distance;
      squaresOfCorners += distance * distance;
    }
    area += weight;
    sum += weight * (9.0 * middle + ofCorners) / 12.0;
    squares += weight * (9.0 * middle * middle + squaresOfCorners) / 12.0;
    const DeviationBounds known = knownOf(from, samples, t);
    if (known.atLeast > result.largest)
    {
      result.largest = known.atLeast;
      result.where = known.where;
    }
  }
  result.mean = area > 0.0 ? sum / area : 0.0;
  result.rms = area > 0.0 ? std::sqrt(squares / area) : 0.0;
  return result;
}

} // namespace

SurfaceDeviation deviationFrom(const TriMesh& from, const TriangleTree& to, Execution& execution)
{
  requireSurfaces(from, to);
  if (from.triangles.empty())
  {
    return {};
  }
  const std::vector<Index> order = curveOrder(from, execution);
  const Samples samples = sample(from, order, to, execution);
  SurfaceDeviation result = summary(from, samples);
  const double diagonal =
    std::max(BoundingBox(from.points).diagonal(), BoundingBox(to.mesh().points).diagonal());
  const double limit = std::max(result.largest * kDeviationSpare, 1e-6 * diagonal);
  const std::vector<Index> mates = matesFor(from, to.mesh(), execution);
  constexpr std::size_t kBlock = 256;
  std::vector<DeviationBounds> blocks((order.size() + kBlock - 1) / kBlock);
  parallelSteps(
    execution, { kPhase, 1, 2 }, blocks.size(),
    [&](std::size_t begin, std::size_t end)
    {
      DeviationBounder bounder(to, mates);
      for (std::size_t i = kBlock * begin; i < std::min(order.size(), kBlock * end); ++i)
      {
        const Index t = order[i];
        const DeviationBounds bounds = bounder.bound(cornerPlaces(from, t), samples.nearest[t],
          samples.ofMiddles[t], knownOf(from, samples, t), limit);
        DeviationBounds& block = blocks[i / kBlock];
        block.atMost = std::max(block.atMost, bounds.atMost);
        if (bounds.atLeast > block.atLeast)
        {
          block.atLeast = bounds.atLeast;
          block.where = bounds.where;
        }
      }
    },
    1);
  for (const DeviationBounds& block : blocks)
  {
    result.atMost = std::max(result.atMost, block.atMost);
    if (block.atLeast > result.largest)
    {
      result.largest = block.atLeast;
      result.where = block.where;
    }
  }
  return result;
}

std::vector<Index> trianglesBeyond(
  const TriMesh& from, const TriangleTree& to, double limit, Execution& execution)
{
  requireSurfaces(from, to);
  const std::vector<Index> order = curveOrder(from, execution);
  std::vector<std::uint8_t> isBeyond(order.size(), 0);
  const std::vector<Index> mates = matesFor(from, to.mesh(), execution);
  constexpr std::size_t kBlock = 256;
  parallelSteps(
    execution, { kPhase }, (order.size() + kBlock - 1) / kBlock,
    [&](std::size_t begin, std::size_t end)
    {
      DeviationBounder bounder(to, mates);
      Index hint = kNone;
      for (std::size_t i = kBlock * begin; i < std::min(order.size(), kBlock * end); ++i)
      {
        const CornerPlaces t = cornerPlaces(from, order[i]);
        const SurfacePlace place = to.nearest(middleOf(t), hint);
        hint = place.triangle;
        isBeyond[order[i]] =
          bounder.isWithin(t, hint, std::sqrt(place.squaredDistance), limit) ? 0 : 1;
      }
    },
    1);
  return collect<Index>(static_cast<Index>(order.size()), execution,
    [&](Index t, std::vector<Index>& found)
    {
      if (isBeyond[t] != 0)
      {
        found.push_back(t);
      }
    });
}

} // namespace scan
