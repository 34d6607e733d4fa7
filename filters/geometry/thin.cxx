// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/thin.h"

#include "filters/geometry/bounding_box.h"
#include "filters/geometry/local_plane.h"
#include "filters/geometry/random.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

namespace scan
{
namespace
{

constexpr std::size_t kNeighbours = 16;
constexpr std::size_t kCheck = 1U << 12U; // steps between checks for cancel

/// The points of the region, with what is to become of them.
struct Selection
{
  std::vector<Index> members; // rising
  std::vector<Vec3> points;
  std::vector<std::uint8_t> isKept; // per member
};

std::size_t countToKeep(std::size_t n, double percent)
{
  return std::min(
    n, static_cast<std::size_t>(std::llround(static_cast<double>(n) * percent / 100)));
}

void thinRandomly(Selection& selection, const ThinOptions& options, Execution& execution)
{
  const std::size_t n = selection.members.size();
  std::size_t wanted = countToKeep(n, options.keep);
  Random random(options.seed);
  for (std::size_t i = 0; i < n && wanted > 0; ++i)
  {
    if (i % kCheck == 0)
    {
      execution.step("thin", i, n);
    }
    if (random.below(n - i) < wanted)
    {
      selection.isKept[i] = 1;
      --wanted;
    }
  }
}

void thinBySpacing(Selection& selection, const ThinOptions& options, Execution& execution)
{
  const Neighbours places(selection.points, execution);
  std::vector<std::uint8_t> isCovered(places.size(), 0);
  std::vector<Neighbour> near;
  for (Index place = 0; place < places.size(); ++place)
  {
    if (place % kCheck == 0)
    {
      execution.step("thin", place, places.size());
    }
    if (isCovered[place] != 0)
    {
      continue;
    }
    selection.isKept[places.pointsAt(place).front()] = 1;
    places.within(places[place], options.spacing, near);
    for (const Neighbour& neighbour : near)
    {
      isCovered[neighbour.place] = 1;
    }
  }
}

void thinByGrid(Selection& selection, const ThinOptions& options, Execution& execution)
{
  const std::vector<Vec3>& points = selection.points;
  const BoundingBox box(points);
  const auto cubeOf = [&](const Vec3& p)
  {
    const Vec3 d = options.spacing > 0.0 ? (p - box.low) * (1.0 / options.spacing) : p - box.low;
    return options.spacing > 0.0 ? Vec3{ std::floor(d.x), std::floor(d.y), std::floor(d.z) } : d;
  };
  struct Member
  {
    Vec3 cube;
    Index point;
  };
  std::vector<Member> sorted(points.size());
  for (Index i = 0; i < points.size(); ++i)
  {
    sorted[i] = { cubeOf(points[i]), i };
  }
  execution.step("thin", 1, 4);
  std::ranges::sort(sorted,
    [](const Member& a, const Member& b)
    {
      return std::tie(a.cube.x, a.cube.y, a.cube.z, a.point) <
        std::tie(b.cube.x, b.cube.y, b.cube.z, b.point);
    });
  execution.step("thin", 3, 4);
  for (auto begin = sorted.begin(); begin != sorted.end();)
  {
    const auto end =
      std::find_if(begin, sorted.end(), [&](const Member& m) { return m.cube != begin->cube; });
    const Vec3 origin = points[begin->point];
    Vec3 sum;
    std::for_each(begin, end, [&](const Member& m) { sum = sum + (points[m.point] - origin); });
    const Vec3 mean = origin + sum * (1.0 / static_cast<double>(end - begin));
    const auto squaredDistance = [&](const Member& m)
    { return dot(points[m.point] - mean, points[m.point] - mean); };
    const auto nearest = std::min_element(begin, end,
      [&](const Member& a, const Member& b) { return squaredDistance(a) < squaredDistance(b); });
    selection.isKept[nearest->point] = 1;
    begin = end;
  }
}

/// Per place how much the surface bends within its neighbours, 0 for a plane.
std::vector<double> bending(const Neighbours& places, Execution& execution)
{
  std::vector<double> bends(places.size());
  parallelSteps(execution, { "thin" }, places.size(),
    [&](std::size_t begin, std::size_t end)
    {
      std::vector<Neighbour> found;
      for (std::size_t i = begin; i < end; ++i)
      {
        places.nearest(places[static_cast<Index>(i)], kNeighbours, found);
        bends[i] = std::sqrt(fitPlane(places, found).variation());
      }
    });
  return bends;
}

/// The factor that makes the chances min(1, factor * weight) add up to `wanted`.
double chanceFactor(std::vector<double> weights, std::size_t wanted)
{
  std::ranges::sort(weights);
  double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  std::size_t certain = 0;
  while (certain < wanted)
  {
    const double factor = static_cast<double>(wanted - certain) / sum;
    const double largest = weights[weights.size() - 1 - certain];
    if (factor * largest <= 1.0)
    {
      return factor;
    }
    sum -= largest;
    ++certain;
  }
  return std::numeric_limits<double>::infinity();
}

void thinByCurvature(Selection& selection, const ThinOptions& options, Execution& execution)
{
  const std::size_t wanted = countToKeep(selection.points.size(), options.keep);
  const Neighbours places(selection.points, execution);
  const std::vector<double> bends = bending(places, execution);
  if (wanted == 0)
  {
    return;
  }
  constexpr double kFlatShare = 0.25; // of the mean bending: the weight of a flat part
  const double mean =
    std::accumulate(bends.begin(), bends.end(), 0.0) / static_cast<double>(bends.size());
  std::vector<double> weights; // point by point, in the order of the places
  for (Index place = 0; place < places.size(); ++place)
  {
    const double weight = mean > 0.0 ? kFlatShare + bends[place] / mean : 1.0;
    weights.insert(weights.end(), places.pointsAt(place).size(), weight);
  }
  const double factor = chanceFactor(weights, wanted);
  double next = Random(options.seed).unit();
  double passed = 0.0;
  std::size_t kept = 0;
  std::size_t i = 0;
  for (Index place = 0; place < places.size(); ++place)
  {
    for (const Index member : places.pointsAt(place))
    {
      passed += std::min(1.0, factor * weights[i++]);
      // rounding of the sum must not lose the last one
      const bool isLast = weights.size() - i < wanted - kept;
      if (kept < wanted && (passed > next || isLast))
      {
        selection.isKept[member] = 1;
        ++kept;
        next += 1.0;
      }
    }
  }
}

} // namespace

std::vector<std::uint8_t> thin(std::span<const Vec3> points, std::span<const std::uint8_t> inRegion,
  const ThinOptions& options, Execution& execution)
{
  execution.step("thin", 0, 1);
  Selection selection;
  for (Index i = 0; i < points.size(); ++i)
  {
    if (inRegion[i] != 0)
    {
      selection.members.push_back(i);
      selection.points.push_back(points[i]);
    }
  }
  selection.isKept.resize(selection.members.size(), 0);
  switch (options.by)
  {
    case ThinOptions::By::random:
      thinRandomly(selection, options, execution);
      break;
    case ThinOptions::By::spacing:
      thinBySpacing(selection, options, execution);
      break;
    case ThinOptions::By::grid:
      thinByGrid(selection, options, execution);
      break;
    case ThinOptions::By::curvature:
      thinByCurvature(selection, options, execution);
      break;
  }
  std::vector<std::uint8_t> isKept(points.size(), 1);
  for (std::size_t i = 0; i < selection.members.size(); ++i)
  {
    isKept[selection.members[i]] = selection.isKept[i];
  }
  execution.step("thin", 1, 1);
  return isKept;
}

} // namespace scan
