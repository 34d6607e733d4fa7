// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/umbrella_steps.h"

#include "filters/geometry/bounding_box.h"
#include "filters/geometry/chebyshev_series.h"
#include "filters/geometry/float4.h"
#include "filters/geometry/limited_move.h"
#include "filters/geometry/smooth_normals.h"

#include <cmath>

namespace scan
{
namespace
{

constexpr std::size_t kGrain = 16384;
constexpr std::size_t kFirstBends = 10; // pairs after which normals are computed anew,
constexpr std::size_t kLaterBends = 8;  // and again after so many times as many

/// Displacements of points, in units of the size of the whole.
class Displacements
{
public:
  Displacements(const UmbrellaSurface& surface, double limit, Execution& execution);

  /// Takes the bend of the surface as it is now out of what pulls.
  void straighten(Execution& execution);
  void step(double weight, bool isHeldBack, Execution& execution);
  /// All at once what many steps from here would do; see seriesOf().
  /// @param onTerm told the number of terms that are left
  template <class OnTerm>
  void sum(std::span<const double> series, OnTerm&& onTerm, Execution& execution);
  std::vector<Vec3> moved(Execution& execution) const;

private:
  /// Of the neighbours; of none: zero.
  Float4 meanOf(const LargeArray<Float4>& values, std::size_t point) const
  {
    const auto near = this->Neighbours.of(point);
    const Float4 sum = sumOf(near, [&](Index other) { return values[other]; });
    return near.empty() ? sum : sum * (1.0F / static_cast<float>(near.size()));
  }
  Float4 heldBack(const Float4& displacement, std::size_t point) const;
  Float4 bend(std::size_t point) const;

  const UmbrellaSurface& Surface;
  const PointLists& Neighbours;
  std::size_t Count;
  double Limit;
  double Scale = 1.0;
  float ScaledLimit = 0.0F;
  LargeArray<Float4> Mean;  // from the first place to the mean of the neighbours there
  LargeArray<Float4> Pull;  // the same without the bend
  LargeArray<Float4> Start; // from home to the first place; none when nothing is held back
  LargeArray<Float4> Now;
  LargeArray<Float4> Next;
  LargeArray<Float4> Places; // while normals are computed; scratch otherwise
  SmoothNormals Normals;
};

Displacements::Displacements(const UmbrellaSurface& surface, double limit, Execution& execution)
  : Surface(surface)
  , Neighbours(surface.neighbours)
  , Count(surface.mesh.points.size())
  , Limit(limit)
  , Mean(this->Count)
  , Pull(this->Count)
  , Start(std::isfinite(limit) ? this->Count : 0)
  , Now(this->Count)
  , Next(this->Count)
  , Places(this->Count)
  , Normals({ surface.mesh.triangles, surface.triangles, surface.neighbours, surface.isSharp })
{
  const std::vector<Vec3>& points = surface.mesh.points;
  const double size = BoundingBox(points).diagonal();
  this->Scale = size > 0.0 ? 1.0 / size : 1.0;
  constexpr double kLess = 1.0 - 1e-6; // so that rounding rarely exceeds the limit
  this->ScaledLimit = static_cast<float>(std::min(limit * this->Scale * kLess, 1e18));
  parallelForEach(execution, this->Count, kGrain,
    [&](std::size_t i)
    {
      Vec3 sum;
      const auto near = this->Neighbours.of(i);
      for (const Index other : near)
      {
        sum = sum + (points[other] - points[i]);
      }
      const double share = near.empty() ? 0.0 : this->Scale / static_cast<double>(near.size());
      this->Mean[i] = narrowed(sum, share);
      this->Now[i] = Float4{};
      if (!this->Start.empty())
      {
        this->Start[i] = narrowed(points[i] - surface.homes[i], this->Scale);
      }
    });
}

/// How far the mean of the neighbours is from where it would be if the surface were flat.
Float4 Displacements::bend(std::size_t point) const
{
  const Float4 normal = this->Normals.of(point);
  const auto near = this->Neighbours.of(point);
  float sum = 0.0F;
  for (const Index other : near)
  {
    const Float4& there = this->Normals.of(other);
    if (dot(normal, there) > 0.0F) // beyond a right angle nothing is known
    {
      sum += dot(this->Places[other] - this->Places[point], normal - there);
    }
  }
  return near.empty() ? Float4{} : normal * (0.5F * sum / static_cast<float>(near.size()));
}

void Displacements::straighten(Execution& execution)
{
  const std::vector<Vec3>& points = this->Surface.mesh.points;
  parallelForEach(execution, this->Count, kGrain,
    [&](std::size_t i)
    { this->Places[i] = narrowed(points[i] - points[0], this->Scale) + this->Now[i]; });
  this->Normals.compute(this->Places, execution);
  parallelForEach(execution, this->Count, kGrain,
    [&](std::size_t i) { this->Pull[i] = this->Mean[i] - this->bend(i); });
}

Float4 Displacements::heldBack(const Float4& displacement, std::size_t point) const
{
  const Float4 whole = this->Start[point] + displacement;
  const float squared = dot(whole, whole);
  if (!(squared > this->ScaledLimit * this->ScaledLimit))
  {
    return displacement;
  }
  return whole * (this->ScaledLimit / std::sqrt(squared)) - this->Start[point];
}

void Displacements::step(double weight, bool isHeldBack, Execution& execution)
{
  const auto by = static_cast<float>(weight);
  parallelForEach(execution, this->Count, kGrain,
    [&](std::size_t i)
    {
      const Float4& now = this->Now[i];
      const Float4 next = now + (this->meanOf(this->Now, i) + this->Pull[i] - now) * by;
      this->Next[i] =
        isHeldBack && !this->Neighbours.of(i).empty() ? this->heldBack(next, i) : next;
    });
  this->Now.swap(this->Next);
}

template <class OnTerm>
void Displacements::sum(std::span<const double> series, OnTerm&& onTerm, Execution& execution)
{
  // the sum of c_m T_m(M) times the first step without its weight (Clenshaw 1955), M the mean of
  // the neighbours
  LargeArray<Float4>& first = this->Pull;
  LargeArray<Float4>& later = this->Next;
  LargeArray<Float4>& latest = this->Places;
  parallelForEach(execution, this->Count, kGrain,
    [&](std::size_t i)
    {
      first[i] = first[i] + this->meanOf(this->Now, i) - this->Now[i];
      later[i] = Float4{};
      latest[i] = Float4{};
    });
  for (std::size_t m = series.size(); m-- > 0;)
  {
    onTerm(m);
    const auto share = static_cast<float>(series[m]);
    const float twice = m > 0 ? 2.0F : 1.0F;
    parallelForEach(execution, this->Count, kGrain,
      [&](std::size_t i)
      { latest[i] = first[i] * share + this->meanOf(later, i) * twice - latest[i]; });
    later.swap(latest);
  }
  parallelForEach(
    execution, this->Count, kGrain, [&](std::size_t i) { this->Now[i] = this->Now[i] + later[i]; });
}

std::vector<Vec3> Displacements::moved(Execution& execution) const
{
  std::vector<Vec3> places(this->Surface.mesh.points);
  parallelForEach(execution, this->Count, kGrain,
    [&](std::size_t i)
    {
      if (!this->Neighbours.of(i).empty())
      {
        const Vec3 to = places[i] + widened(this->Now[i], 1.0 / this->Scale);
        places[i] = limitedMove(this->Surface.homes[i], to, this->Limit);
      }
    });
  return places;
}

/// As a step by weight w takes d to d + w (p - L d), L the difference from the mean of the
/// neighbours and p the pull, many take it to d + g(L) (p - L d), g(k) = (1 - the product of 1 - w
/// k) / k. Of g for all that L may hold, 0 to 2, the series in T_m(1 - k); empty when it is not
/// shorter than the steps.
std::vector<double> seriesOf(const UmbrellaSteps& steps, std::size_t pairs)
{
  constexpr std::size_t kMost = 256;  // far more than weights that smooth ever need
  constexpr double kTolerance = 1e-6; // of the movement
  const std::size_t passes = 2 * pairs;
  std::vector<double> series = chebyshevSeries(std::min(passes, kMost),
    [&](double x)
    {
      const double k = 1.0 - x;
      const double pair = (1.0 - steps.lambda * k) * (1.0 - steps.mu * k);
      return (1.0 - std::pow(pair, static_cast<double>(pairs))) / k;
    });
  truncate(series, kTolerance);
  if (series.size() + 1 >= passes || series.size() == kMost)
  {
    series.clear();
  }
  return series;
}

} // namespace

std::vector<Vec3> umbrellaSteps(const UmbrellaSurface& surface, const UmbrellaSteps& steps,
  std::string_view phase, Execution& execution)
{
  const bool isLimited = std::isfinite(steps.limit);
  const auto pairs = static_cast<std::size_t>(steps.pairs);
  Displacements displacements(surface, steps.limit, execution);
  std::size_t next = 0;
  for (std::size_t pair = 0; pair < pairs; pair = next)
  {
    execution.step(phase, pair, pairs);
    displacements.straighten(execution);
    next = std::min(pairs, std::max(kFirstBends, kLaterBends * pair));
    const std::vector<double> series =
      isLimited ? std::vector<double>{} : seriesOf(steps, next - pair);
    if (!series.empty())
    {
      const std::size_t terms = series.size();
      displacements.sum(
        series,
        [&](std::size_t left)
        { execution.step(phase, next * terms - (next - pair) * left, pairs * terms); },
        execution);
      continue;
    }
    for (; pair < next; ++pair)
    {
      execution.step(phase, pair, pairs);
      displacements.step(steps.lambda, false, execution);
      displacements.step(steps.mu, isLimited, execution);
    }
  }
  return displacements.moved(execution);
}

} // namespace scan
