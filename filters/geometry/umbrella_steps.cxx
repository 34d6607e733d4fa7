// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/umbrella_steps.h"

#include "filters/geometry/bounding_box.h"
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
  std::vector<Vec3> moved(Execution& execution) const;

private:
  template <bool isHeldBack>
  void stepRange(float weight, std::size_t begin, std::size_t end);
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
  LargeArray<Float4> Places;
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
      this->Now[i] = {};
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

template <bool isHeldBack>
void Displacements::stepRange(float weight, std::size_t begin, std::size_t end)
{
  const Index* const items = this->Neighbours.items.data();
  const Index* const begins = this->Neighbours.begins.data();
  const Float4* const now = this->Now.data();
  for (std::size_t i = begin; i < end; ++i)
  {
    Float4 sum;
    const Index first = begins[i];
    const Index last = begins[i + 1];
    for (Index k = first; k < last; ++k)
    {
      sum = sum + now[items[k]];
    }
    const float share = last > first ? 1.0F / static_cast<float>(last - first) : 0.0F;
    Float4 next = now[i] + (sum * share + this->Pull[i] - now[i]) * weight;
    if constexpr (isHeldBack)
    {
      next = last > first ? this->heldBack(next, i) : now[i];
    }
    this->Next[i] = next;
  }
}

void Displacements::step(double weight, bool isHeldBack, Execution& execution)
{
  execution.parallelFor(this->Count, kGrain,
    [&](std::size_t begin, std::size_t end)
    {
      isHeldBack ? this->stepRange<true>(static_cast<float>(weight), begin, end)
                 : this->stepRange<false>(static_cast<float>(weight), begin, end);
    });
  this->Now.swap(this->Next);
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

} // namespace

std::vector<Vec3> umbrellaSteps(const UmbrellaSurface& surface, const UmbrellaSteps& steps,
  std::string_view phase, Execution& execution)
{
  const bool isLimited = std::isfinite(steps.limit);
  const auto pairs = static_cast<std::size_t>(steps.pairs);
  Displacements displacements(surface, steps.limit, execution);
  std::size_t straightened = 0;
  for (std::size_t pair = 0; pair < pairs; ++pair)
  {
    execution.step(phase, pair, pairs);
    if (pair == straightened)
    {
      displacements.straighten(execution);
      straightened = std::max(kFirstBends, kLaterBends * pair);
    }
    displacements.step(steps.lambda, false, execution);
    displacements.step(steps.mu, isLimited, execution);
  }
  return displacements.moved(execution);
}

} // namespace scan
