// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/guided_filter.h"

#include "filters/geometry/limited_move.h"
#include "filters/geometry/local_plane.h"

#include <cmath>

namespace scan
{
namespace
{

constexpr std::size_t kGrain = 2048;
constexpr int kMoves = 10; // of the points in a round

/// Triangles around a triangle, all that share a corner, as one.
struct Patch
{
  Vec3 normal;         // mean
  double spread = 2.0; // 0 where all normals agree, up to 1
};

class Faces
{
public:
  Faces(const TriMesh& mesh, const PointLists& trianglesOfPoints, Execution& execution)
    : Triangles(mesh.triangles)
    , AtPoint(trianglesOfPoints)
    , Run(execution)
    , Areas(mesh.triangles.size())
    , Normals(mesh.triangles.size())
    , Patches(mesh.triangles.size())
    , Guides(mesh.triangles.size())
  {
  }

  void measure(const std::vector<Vec3>& points);
  void guide();
  void mix(double angle);
  const std::vector<Vec3>& normals() const { return this->Normals; }

private:
  template <class Visit>
  void forAround(std::size_t triangle, Visit&& visit) const
  {
    for (const Index point : this->Triangles[triangle])
    {
      for (const Index other : this->AtPoint.of(point))
      {
        visit(other);
      }
    }
  }
  template <class Body>
  void forAll(Body&& body)
  {
    parallelForEach(this->Run, this->Triangles.size(), kGrain, body);
  }

  const std::vector<Triangle>& Triangles;
  const PointLists& AtPoint;
  Execution& Run;
  std::vector<double> Areas;
  std::vector<Vec3> Normals;
  std::vector<Patch> Patches;
  std::vector<Vec3> Guides;
};

void Faces::measure(const std::vector<Vec3>& points)
{
  this->forAll(
    [&](std::size_t t)
    {
      const auto& [a, b, c] = this->Triangles[t];
      const Vec3 area = cross(points[b] - points[a], points[c] - points[a]);
      this->Areas[t] = length(area);
      this->Normals[t] = unitVector(area);
    });
}

void Faces::guide()
{
  this->forAll(
    [&](std::size_t t)
    {
      Vec3 sum;
      double area = 0.0;
      this->forAround(t,
        [&](Index other)
        {
          sum = sum + this->Normals[other] * this->Areas[other];
          area += this->Areas[other];
        });
      this->Patches[t] = { unitVector(sum), area > 0.0 ? 1.0 - length(sum) / area : 2.0 };
    });
  this->forAll(
    [&](std::size_t t)
    {
      Patch best;
      this->forAround(t,
        [&](Index other)
        {
          if (this->Patches[other].spread < best.spread)
          {
            best = this->Patches[other];
          }
        });
      this->Guides[t] = best.normal;
    });
}

void Faces::mix(double angle)
{
  const double chord = 2.0 * std::sin(0.5 * angle);
  std::vector<Vec3> mixed(this->Normals.size());
  this->forAll(
    [&](std::size_t t)
    {
      Vec3 sum;
      this->forAround(t,
        [&](Index other)
        {
          const Vec3 d = this->Guides[other] - this->Guides[t];
          const double near = 1.0 - dot(d, d) / (chord * chord);
          if (near > 0.0)
          {
            sum = sum + this->Normals[other] * (this->Areas[other] * near * near);
          }
        });
      mixed[t] = unitVector(sum);
    });
  this->Normals.swap(mixed);
}

} // namespace

GuidedResult guidedFilter(const TriMesh& mesh, const PointLists& trianglesOfPoints,
  std::span<const std::uint8_t> isMovable, const GuidedFilter& options, std::string_view phase,
  Execution& execution)
{
  GuidedResult result{ mesh.points, {} };
  std::vector<Vec3> next(mesh.points.size());
  Faces faces(mesh, trianglesOfPoints, execution);
  const auto movePoint = [&](std::size_t i)
  {
    const std::vector<Vec3>& points = result.points;
    const auto around = trianglesOfPoints.of(i);
    if (isMovable[i] == 0 || around.empty())
    {
      return points[i];
    }
    Vec3 sum;
    for (const Index t : around)
    {
      const auto& [a, b, c] = mesh.triangles[t];
      const Vec3 d = (points[a] + points[b] + points[c]) * (1.0 / 3.0) - points[i];
      sum = sum + faces.normals()[t] * dot(faces.normals()[t], d);
    }
    const Vec3 to = points[i] + sum * (1.0 / static_cast<double>(around.size()));
    return limitedMove(mesh.points[i], to, options.limit);
  };
  for (int round = 0; round < options.rounds; ++round)
  {
    execution.step(
      phase, static_cast<std::size_t>(round), static_cast<std::size_t>(options.rounds));
    faces.measure(result.points);
    faces.guide();
    faces.mix(options.angle);
    for (int move = 0; move < kMoves; ++move)
    {
      parallelForEach(
        execution, next.size(), kGrain, [&](std::size_t i) { next[i] = movePoint(i); });
      result.points.swap(next);
    }
  }
  result.normals = faces.normals();
  return result;
}

} // namespace scan
