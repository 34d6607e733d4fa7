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

/// A 3 x 3 matrix.
struct Matrix
{
  Float4 x{}, y{}, z{}; ///< columns

  /// The outer product a b'.
  void add(const Float4& a, const Float4& b)
  {
    this->x = this->x + a * b.lanes[0];
    this->y = this->y + a * b.lanes[1];
    this->z = this->z + a * b.lanes[2];
  }
  Float4 operator*(const Float4& v) const
  {
    return this->x * v.lanes[0] + this->y * v.lanes[1] + this->z * v.lanes[2];
  }
};

/// The symmetric map S of the plane across a normal that fits turns of normals to steps in the
/// plane: the least sum of |S step - turn|^2.
class ShapeOperator
{
public:
  void add(const Float4& step, const Float4& turn)
  {
    this->Steps.add(step, step);
    this->Turns.add(turn, step);
  }

  /// The turn that a step brings; none when there were too few steps to tell.
  Float4 turn(const Float4& normal, const Float4& step) const
  {
    const bool isAlongX = std::abs(normal.lanes[0]) > 0.6F;
    const Float4 axis{ isAlongX ? Float4::Lanes{ 0, 1, 0, 0 } : Float4::Lanes{ 1, 0, 0, 0 } };
    const Float4 u = unit(axis - normal * dot(normal, axis));
    const Float4 v = cross(normal, u);
    const Float4 stepsV = this->Steps * v;
    const float uu = dot(u, this->Steps * u);
    const float uv = dot(u, stepsV);
    const float vv = dot(v, stepsV);
    constexpr float kThin = 1e-4F; // steps along a line
    const float trace = uu + vv;
    if (!(uu * vv - uv * uv > kThin * trace * trace))
    {
      return Float4{};
    }
    const Float4 turnsU = this->Turns * u;
    const Float4 turnsV = this->Turns * v;
    const float turnU = dot(u, turnsU);
    const float turnUV = dot(u, turnsV) + dot(v, turnsU);
    const float turnV = dot(v, turnsV);
    // the normal equations of S = ((a, b), (b, c)), a and c eliminated
    const float byU = uv / uu;
    const float byV = uv / vv;
    const float b = (turnUV - byU * turnU - byV * turnV) / (trace - byU * uv - byV * uv);
    const float a = (turnU - b * uv) / uu;
    const float c = (turnV - b * uv) / vv;
    const float x = dot(step, u);
    const float y = dot(step, v);
    return u * (a * x + b * y) + v * (b * x + c * y);
  }

private:
  Matrix Steps; // the sum of step step'
  Matrix Turns; // of turn step'
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
  Float4 sum{};
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
  constexpr int kRounds = 10;
  constexpr float kOwn = 0.25F; // without it even and odd rounds would see different points
  for (int round = 0; round < kRounds; ++round)
  {
    parallelForEach(execution, this->Count, kGrain,
      [&](std::size_t i)
      {
        const auto near = this->Surface.neighbours.of(i);
        const Float4 area = sumOf(near, [&](Index other) { return this->Means[other].area; });
        const Float4 place = sumOf(near, [&](Index other) { return this->Means[other].place; });
        const bool isAlone = near.empty() || this->Surface.isSharp[i] != 0;
        const float share = isAlone ? 0.0F : 1.0F / static_cast<float>(near.size());
        const float own = isAlone ? 1.0F : kOwn;
        this->Next[i] = { this->Means[i].area * own + area * share,
          this->Means[i].place * own + place * share };
      });
    this->Means.swap(this->Next);
  }
}

/// The normal of the mean, turned as the surface turns from the mean place to the point.
Float4 SmoothNormals::normalAt(const Float4& place, std::size_t point) const
{
  const Mean& mean = this->Means[point];
  ShapeOperator shape;
  for (const Index other : this->Surface.neighbours.of(point))
  {
    const Mean& there = this->Means[other];
    if (dot(there.area, mean.area) > 0.0F)
    {
      shape.add(there.place - mean.place, there.area - mean.area);
    }
  }
  return unit(mean.area + shape.turn(mean.area, place - mean.place));
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
