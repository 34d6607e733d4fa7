// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/denoise.h"

#include "filters/geometry/limited_move.h"
#include "filters/geometry/local_plane.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace scan
{
namespace
{

constexpr std::size_t kLeast = 8;                 // places for a quadric
constexpr int kNormalRounds = 3;                  // of filtering
constexpr std::size_t kLoops = 2 + kNormalRounds; // over all places in an iteration
constexpr double kSoftAngle = 0.4; // radians between normals where a weight has fallen to 1/e
constexpr int kFits = 3;           // of one quadric: what is far off counts less each time
constexpr double kFar = 8.0;       // variances where a weight has fallen to 1/e

/// Falls from 1 to 0.
double bell(double squared)
{
  return std::exp(-squared);
}

using Terms = Eigen::Matrix<double, 6, 1>; // 1, u, v, uu, uv, vv

/// The coefficients of the quadric that fits the heights best, robustly.
Terms fitQuadric(const std::vector<Terms>& terms, const std::vector<double>& heights,
  const std::vector<double>& weights)
{
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  Terms quadric = Terms::Zero();
  double variance = std::numeric_limits<double>::infinity(); // of residuals
  for (int fit = 0; fit < kFits; ++fit)
  {
    Eigen::Matrix<double, 6, 6> matrix = Eigen::Matrix<double, 6, 6>::Zero();
    Terms right = Terms::Zero();
    double squares = 0.0;
    for (std::size_t i = 0; i < terms.size(); ++i)
    {
      const double residual = heights[i] - terms[i].dot(quadric);
      const double weight = weights[i] * bell(residual * residual / (kFar * variance));
      matrix += weight * terms[i] * terms[i].transpose();
      right += weight * heights[i] * terms[i];
    }
    constexpr double kFlat = 1e-6; // prefers a plane where the neighbours do not tell
    matrix.diagonal().tail<3>().array() += kFlat * sum;
    matrix.diagonal().head<3>().array() += kFlat * kFlat * sum;
    quadric = matrix.ldlt().solve(right);
    for (std::size_t i = 0; i < terms.size(); ++i)
    {
      const double residual = heights[i] - terms[i].dot(quadric);
      squares += weights[i] * residual * residual;
    }
    variance = squares / sum;
    if (!(variance > 0.0))
    {
      break;
    }
  }
  return quadric;
}

/// The surface around the places of one iteration.
class Surface
{
public:
  /// @param loop the next of kLoops
  Surface(
    const Neighbours& places, std::size_t neighbours, LoopOfPhase& loop, Execution& execution);

  /// How far the place is from the surface along its normal.
  double heightAt(Index place) const;
  const Vec3& normalAt(Index place) const { return this->Normals[place]; }

private:
  std::span<const Index> nearOf(Index place) const
  {
    return { this->Near.data() + place * this->Count, this->Count };
  }
  /// The weight of a place for another with that normal.
  double weight(const Vec3& normal, Index other, double squaredDistance) const
  {
    const double cosine = std::min(1.0, std::abs(dot(normal, this->Normals[other])));
    const double squaredAngle = 2.0 * (1.0 - cosine);
    return bell(squaredDistance + squaredAngle / (kSoftAngle * kSoftAngle));
  }
  void filterNormals(const LoopOfPhase& loop, Execution& execution);

  const Neighbours& Places;
  std::size_t Count;
  std::vector<Index> Near; // Count per place, itself first
  std::vector<double> Reach;
  std::vector<Vec3> Normals;
};

Surface::Surface(
  const Neighbours& places, std::size_t neighbours, LoopOfPhase& loop, Execution& execution)
  : Places(places)
  , Count(std::min<std::size_t>(neighbours + 1, places.size()))
  , Near(places.size() * this->Count)
  , Reach(places.size())
  , Normals(places.size())
{
  parallelSteps(execution, loop, places.size(),
    [&](std::size_t begin, std::size_t end)
    {
      std::vector<Neighbour> found;
      for (std::size_t i = begin; i < end; ++i)
      {
        places.nearest(places[static_cast<Index>(i)], this->Count, found);
        std::ranges::transform(found,
          this->Near.begin() + static_cast<std::ptrdiff_t>(i * this->Count),
          [](const Neighbour& n) { return n.place; });
        this->Reach[i] = std::sqrt(found.back().squaredDistance);
        found.resize(std::max(found.size() / 2, std::min(found.size(), kLeast)));
        this->Normals[i] = fitPlane(places, found).normal;
      }
    });
  for (int round = 0; round < kNormalRounds; ++round)
  {
    ++loop.loop;
    this->filterNormals(loop, execution);
  }
}

void Surface::filterNormals(const LoopOfPhase& loop, Execution& execution)
{
  std::vector<Vec3> filtered(this->Normals.size());
  parallelSteps(execution, loop, filtered.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        const auto place = static_cast<Index>(i);
        const Vec3& normal = this->Normals[i];
        const double squaredReach = this->Reach[i] * this->Reach[i];
        Vec3 sum;
        for (const Index other : this->nearOf(place))
        {
          const Vec3 d = this->Places[other] - this->Places[place];
          const double share = this->weight(normal, other, 4.0 * dot(d, d) / squaredReach);
          const double sign = dot(normal, this->Normals[other]) < 0.0 ? -1.0 : 1.0;
          sum = sum + this->Normals[other] * (sign * share);
        }
        filtered[i] = unitVector(sum);
      }
    });
  this->Normals.swap(filtered);
}

double Surface::heightAt(Index place) const
{
  const Vec3& normal = this->Normals[place];
  const double reach = this->Reach[place];
  if (this->Count < kLeast || normal == Vec3{} || !(reach > 0.0))
  {
    return 0.0;
  }
  const Vec3 aside = std::abs(normal.x) < 0.6 ? Vec3{ 1, 0, 0 } : Vec3{ 0, 1, 0 };
  const Vec3 first = unitVector(cross(normal, aside));
  const Vec3 second = cross(normal, first);
  const auto near = this->nearOf(place);
  std::vector<Terms> terms(near.size());
  std::vector<double> heights(near.size());
  std::vector<double> weights(near.size());
  for (std::size_t i = 0; i < near.size(); ++i)
  {
    const Vec3 d = (this->Places[near[i]] - this->Places[place]) * (1.0 / reach);
    const double u = dot(d, first);
    const double v = dot(d, second);
    terms[i] << 1.0, u, v, u * u, u * v, v * v;
    heights[i] = dot(d, normal);
    weights[i] = this->weight(normal, near[i], 2.0 * dot(d, d));
  }
  const double height = fitQuadric(terms, heights, weights)[0];
  return std::isfinite(height) ? reach * height : 0.0;
}

} // namespace

DenoiseResult denoise(std::span<const Vec3> points, std::span<const std::uint8_t> inRegion,
  const DenoiseOptions& options, Execution& execution)
{
  DenoiseResult result;
  result.points.assign(points.begin(), points.end());
  std::vector<std::uint8_t> isLimited(points.size(), 0);
  const auto iterations = static_cast<std::size_t>(options.iterations);
  for (std::size_t iteration = 0; iteration < iterations; ++iteration)
  {
    LoopOfPhase loop{ "denoise", iteration * kLoops, iterations * kLoops };
    const Neighbours places(result.points, execution);
    const Surface surface(places, options.neighbours, loop, execution);
    ++loop.loop;
    parallelSteps(execution, loop, places.size(),
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t i = begin; i < end; ++i)
        {
          const auto place = static_cast<Index>(i);
          const Vec3 to = places[place] + surface.normalAt(place) * surface.heightAt(place);
          for (const Index point : places.pointsAt(place))
          {
            if (inRegion[point] != 0)
            {
              result.points[point] = limitedMove(points[point], to, options.maxShift);
              isLimited[point] = result.points[point] != to ? 1 : 0;
            }
          }
        }
      });
  }
  double sum = 0.0;
  std::size_t members = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const double shift = length(result.points[i] - points[i]);
    sum += shift;
    members += inRegion[i];
    result.moved += shift > 0.0 ? 1 : 0;
    result.limited += isLimited[i];
    result.largestShift = std::max(result.largestShift, shift);
  }
  result.meanShift = members > 0 ? sum / static_cast<double>(members) : 0.0;
  execution.step("denoise", 1, 1);
  return result;
}

} // namespace scan
