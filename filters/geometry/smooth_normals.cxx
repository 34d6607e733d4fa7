// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/smooth_normals.h"

#include <cmath>

namespace scan
{
namespace
{

constexpr std::size_t kGrain = 16384;

Float4 unit(const Float4& v)
{
  const float squared = dot(v, v);
  return squared > 0.0F ? v * (1.0F / std::sqrt(squared)) : Float4{};
}

/// The symmetric map S of a plane that fits turns of a normal to steps in the plane: the least sum
/// of |S step - turn|^2.
class ShapeOperator
{
public:
  explicit ShapeOperator(const Float4& normal)
  {
    const bool isAlongX = std::abs(normal.lanes[0]) > 0.6F;
    const Float4 axis{ isAlongX ? Float4::Lanes{ 0, 1, 0, 0 } : Float4::Lanes{ 1, 0, 0, 0 } };
    this->U = unit(axis - normal * dot(normal, axis));
    this->V = cross(normal, this->U);
  }

  void add(const Float4& step, const Float4& turn)
  {
    const float x = dot(step, this->U);
    const float y = dot(step, this->V);
    const float turnX = dot(turn, this->U);
    const float turnY = dot(turn, this->V);
    this->XX += x * x;
    this->XY += x * y;
    this->YY += y * y;
    this->TurnX += turnX * x;
    this->TurnXY += turnX * y + turnY * x;
    this->TurnY += turnY * y;
  }

  /// The turn that a step brings; none when there were too few steps to tell.
  Float4 turn(const Float4& step) const
  {
    constexpr float kThin = 1e-4F; // steps along a line
    const float trace = this->XX + this->YY;
    if (!(this->XX * this->YY - this->XY * this->XY > kThin * trace * trace))
    {
      return {};
    }
    // the normal equations of S = ((a, b), (b, c)), a and c eliminated
    const float byX = this->XY / this->XX;
    const float byY = this->XY / this->YY;
    const float b = (this->TurnXY - byX * this->TurnX - byY * this->TurnY) /
      (trace - byX * this->XY - byY * this->XY);
    const float a = (this->TurnX - b * this->XY) / this->XX;
    const float c = (this->TurnY - b * this->XY) / this->YY;
    const float x = dot(step, this->U);
    const float y = dot(step, this->V);
    return this->U * (a * x + b * y) + this->V * (b * x + c * y);
  }

private:
  Float4 U;
  Float4 V;
  float XX = 0.0F;
  float XY = 0.0F;
  float YY = 0.0F;
  float TurnX = 0.0F;
  float TurnXY = 0.0F;
  float TurnY = 0.0F;
};

} // namespace

SmoothNormals::SmoothNormals(const NormalSurface& surface)
  : Surface(surface)
  , Count(surface.isSharp.size())
  , Means(this->Count)
  , Next(this->Count)
  , Normals(this->Count)
{
}

/// The sum of the vectors of the triangles at a point: of the length of their area, twice.
Float4 SmoothNormals::areaVector(const LargeArray<Float4>& places, std::size_t point) const
{
  Float4 sum;
  if (this->Surface.isSharp[point] == 0)
  {
    for (const Index t : this->Surface.trianglesOfPoints.of(point))
    {
      const auto& [a, b, c] = this->Surface.triangles[t];
      sum = sum + cross(places[b] - places[a], places[c] - places[a]);
    }
  }
  return sum;
}

/// The weights of a neighbourhood fall with the distance.
void SmoothNormals::average(Execution& execution)
{
  constexpr int kRounds = 7;
  constexpr float kOwn = 0.25F; // without it even and odd rounds would see different points
  for (int round = 0; round < kRounds; ++round)
  {
    parallelForEach(execution, this->Count, kGrain,
      [&](std::size_t i)
      {
        const auto near = this->Surface.neighbours.of(i);
        Mean sum;
        for (const Index other : near)
        {
          sum.area = sum.area + this->Means[other].area;
          sum.place = sum.place + this->Means[other].place;
        }
        const bool isAlone = near.empty() || this->Surface.isSharp[i] != 0;
        const float share = isAlone ? 0.0F : 1.0F / static_cast<float>(near.size());
        const float own = isAlone ? 1.0F : kOwn;
        this->Next[i] = { this->Means[i].area * own + sum.area * share,
          this->Means[i].place * own + sum.place * share };
      });
    this->Means.swap(this->Next);
  }
}

/// The normal of the mean, turned as the surface turns from the mean place to the point.
Float4 SmoothNormals::normalAt(const Float4& place, std::size_t point) const
{
  const Mean& mean = this->Means[point];
  ShapeOperator shape(mean.area);
  for (const Index other : this->Surface.neighbours.of(point))
  {
    const Mean& there = this->Means[other];
    if (dot(there.area, mean.area) > 0.0F)
    {
      shape.add(there.place - mean.place, there.area - mean.area);
    }
  }
  return unit(mean.area + shape.turn(place - mean.place));
}

void SmoothNormals::compute(const LargeArray<Float4>& places, Execution& execution)
{
  parallelForEach(execution, this->Count, kGrain,
    [&](std::size_t i)
    {
      const Float4 area = this->areaVector(places, i);
      const float weight = std::sqrt(dot(area, area));
      Float4 place = places[i] * weight;
      place.lanes[3] = weight;
      this->Means[i] = { area, place };
    });
  this->average(execution);
  parallelForEach(execution, this->Count, kGrain,
    [&](std::size_t i)
    {
      Mean& mean = this->Means[i];
      const float weight = mean.place.lanes[3];
      mean.area = unit(mean.area);
      mean.place = weight > 0.0F ? mean.place * (1.0F / weight) : places[i];
      mean.place.lanes[3] = 0.0F;
    });
  parallelForEach(execution, this->Count, kGrain,
    [&](std::size_t i) { this->Normals[i] = this->normalAt(places[i], i); });
}

} // namespace scan
