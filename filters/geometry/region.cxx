// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/region.h"

#include "filters/base/error.h"
#include "filters/geometry/bounding_box.h"
#include "filters/geometry/half_edges.h"
#include "filters/geometry/mean_curvature.h"
#include "filters/geometry/model_length.h"
#include "filters/geometry/point_triangle.h"
#include "filters/geometry/screen_polygon.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

namespace scan
{
namespace
{

using Flags = std::vector<std::uint8_t>;
using Kind = RegionRule::Kind;

constexpr std::size_t kGrain = 1 << 12;
constexpr std::size_t kFineGrain = 1 << 8;

bool isBetween(double value, double a, double b)
{
  return value >= std::min(a, b) && value <= std::max(a, b);
}

/// Applies the nodes of a rule to one domain.
class Chooser
{
public:
  Chooser(const RegionDomain& domain, Execution& execution)
    : Domain(domain)
    , Mesh(domain.mesh)
    , Run(execution)
  {
    requireCorners(this->Mesh);
    this->Places = this->isOfTriangles() ? this->centroids() : this->Mesh.points;
  }

  Flags choose(const RegionRule& rule);

private:
  bool isOfTriangles() const { return this->Domain.elements == RegionElements::triangles; }
  std::vector<Vec3> centroids();
  Flags chooseShape(const RegionRule& rule);
  Flags chooseSeen(const RegionRule& rule);
  Flags combine(const RegionRule& rule);
  Flags brush(const RegionRule& rule);
  Flags numbered(const RegionRule& rule);
  Flags inRange(const RegionRule& rule, const std::vector<double>& values);
  Flags partsOf(const Flags& touched);
  Flags opposite(Flags flags);
  std::vector<double> curvatures();
  std::vector<double> values(const std::string& name);
  Index nearestTo(const Vec3& point);
  double radiusOf(const RegionRule& rule);
  const RegionAdjacency& adjacency();

  /// 1 for the elements whose number is `inside`.
  template <class Inside>
  Flags where(const Inside& inside)
  {
    Flags flags(this->Places.size());
    this->Run.parallelFor(flags.size(), kGrain,
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t i = begin; i < end; ++i)
        {
          flags[i] = inside(i) ? 1 : 0;
        }
      });
    return flags;
  }

  const RegionDomain& Domain;
  const TriMesh& Mesh;
  Execution& Run;
  std::vector<Vec3> Places; ///< per element
  std::unique_ptr<RegionAdjacency> Adjacency;
};

std::vector<Vec3> Chooser::centroids()
{
  std::vector<Vec3> places(this->Mesh.triangles.size());
  this->Run.parallelFor(places.size(), kGrain,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        const auto& [a, b, c] = this->Mesh.triangles[i];
        const std::vector<Vec3>& points = this->Mesh.points;
        places[i] = (points[a] + points[b] + points[c]) * (1.0 / 3.0);
      }
    });
  return places;
}

Flags Chooser::choose(const RegionRule& rule)
{
  this->Run.step("region", 0, 1);
  switch (rule.kind)
  {
    case Kind::opposite:
    case Kind::both:
    case Kind::either:
    case Kind::without:
      return this->combine(rule);
    case Kind::rectangle:
    case Kind::polygon:
    case Kind::depth:
      return this->chooseSeen(rule);
    case Kind::curvature:
      return this->inRange(rule, this->curvatures());
    case Kind::array:
      return this->inRange(rule, this->values(rule.array));
    case Kind::grow:
      return this->adjacency().grow(this->choose(rule.parts.front()),
        static_cast<std::size_t>(rule.numbers.front()), this->Run);
    case Kind::shrink:
      return this->opposite(this->adjacency().grow(this->opposite(this->choose(rule.parts.front())),
        static_cast<std::size_t>(rule.numbers.front()), this->Run));
    case Kind::componentOf:
      return this->partsOf(this->choose(rule.parts.front()));
    case Kind::points:
    case Kind::triangles:
      return this->numbered(rule);
    default:
      return this->chooseShape(rule);
  }
}

Flags Chooser::chooseShape(const RegionRule& rule)
{
  const std::vector<double>& v = rule.numbers;
  const std::vector<Vec3>& places = this->Places;
  switch (rule.kind)
  {
    case Kind::all:
      return Flags(places.size(), 1);
    case Kind::box:
      return this->where(
        [&](std::size_t i)
        {
          return isBetween(places[i].x, v[0], v[3]) && isBetween(places[i].y, v[1], v[4]) &&
            isBetween(places[i].z, v[2], v[5]);
        });
    case Kind::sphere:
    {
      const Vec3 centre = vectorAt(v, 0);
      const double radius = this->radiusOf(rule);
      return this->where([&](std::size_t i)
        { return dot(places[i] - centre, places[i] - centre) <= radius * radius; });
    }
    case Kind::plane:
    {
      const Vec3 point = vectorAt(v, 0);
      const Vec3 normal = vectorAt(v, 3);
      return this->where([&](std::size_t i) { return dot(places[i] - point, normal) >= 0.0; });
    }
    case Kind::brush:
      return this->brush(rule);
    case Kind::componentAt:
    {
      Flags touched(places.size(), 0);
      if (!places.empty())
      {
        touched[this->nearestTo(vectorAt(v, 0))] = 1;
      }
      return this->partsOf(touched);
    }
    default:
      return Flags(places.size(), 0);
  }
}

Flags Chooser::chooseSeen(const RegionRule& rule)
{
  const Screen screen(rule.view);
  const std::vector<double>& v = rule.numbers;
  if (rule.kind == Kind::depth)
  {
    const Vec3 limit = vectorAt(v, 0);
    return this->where([&](std::size_t i) { return screen.nearer(this->Places[i], limit) >= 0.0; });
  }
  if (rule.kind == Kind::rectangle)
  {
    return this->where(
      [&](std::size_t i)
      {
        const auto at = screen.project(this->Places[i]);
        return at && isBetween(at->x, v[0], v[2]) && isBetween(at->y, v[1], v[3]);
      });
  }
  std::vector<ScreenPoint> corners;
  for (std::size_t i = 0; i < v.size(); i += 2)
  {
    corners.push_back({ v[i], v[i + 1] });
  }
  const ScreenPolygon polygon(corners);
  return this->where(
    [&](std::size_t i)
    {
      const auto at = screen.project(this->Places[i]);
      return at && polygon.contains(*at);
    });
}

Flags Chooser::combine(const RegionRule& rule)
{
  Flags flags = this->choose(rule.parts.front());
  if (rule.kind == Kind::opposite)
  {
    return this->opposite(std::move(flags));
  }
  for (std::size_t part = 1; part < rule.parts.size(); ++part)
  {
    const Flags other = this->choose(rule.parts[part]);
    for (std::size_t i = 0; i < flags.size(); ++i)
    {
      flags[i] = static_cast<std::uint8_t>(rule.kind == Kind::both ? flags[i] & other[i]
          : rule.kind == Kind::either                              ? flags[i] | other[i]
                                                                   : flags[i] & (1 - other[i]));
    }
  }
  return flags;
}

Flags Chooser::opposite(Flags flags)
{
  for (std::uint8_t& flag : flags)
  {
    flag = flag == 0 ? 1 : 0;
  }
  return flags;
}

Flags Chooser::brush(const RegionRule& rule)
{
  std::vector<Vec3> stroke;
  for (std::size_t i = 0; i < rule.numbers.size(); i += 3)
  {
    stroke.push_back(vectorAt(rule.numbers, i));
  }
  const double radius = this->radiusOf(rule);
  const double most = radius * radius;
  const BoundingBox box(stroke);
  return this->where(
    [&](std::size_t element)
    {
      const Vec3& p = this->Places[element];
      if (box.squaredDistance(p) > most)
      {
        return false;
      }
      const Vec3 d = p - stroke.front();
      double nearest = dot(d, d);
      for (std::size_t i = 1; i < stroke.size() && nearest > most; ++i)
      {
        nearest = squaredDistance(p, stroke[i - 1], stroke[i], stroke[i]);
      }
      return nearest <= most;
    });
}

Flags Chooser::numbered(const RegionRule& rule)
{
  const bool isTriangles = rule.kind == Kind::triangles;
  const std::string name = isTriangles ? "triangles" : "points";
  if (isTriangles != this->isOfTriangles())
  {
    throw Error(ErrorCode::badParameter,
      "region: " + name + "() is for a model of " + name + ", and this one is of " +
        (isTriangles ? "points" : "triangles") + "; choose by place instead");
  }
  Flags flags(this->Places.size(), 0);
  for (const double number : rule.numbers)
  {
    if (number >= static_cast<double>(flags.size()))
    {
      throw Error(ErrorCode::badParameter,
        "region: there is no " + std::to_string(static_cast<Index>(number)) + " among the " +
          std::to_string(flags.size()) + " " + name + ", counted from 0");
    }
    flags[static_cast<std::size_t>(number)] = 1;
  }
  return flags;
}

Flags Chooser::inRange(const RegionRule& rule, const std::vector<double>& values)
{
  return this->where(
    [&](std::size_t i) { return values[i] >= rule.numbers[0] && values[i] <= rule.numbers[1]; });
}

Flags Chooser::partsOf(const Flags& touched)
{
  const std::vector<Index> parts = this->adjacency().parts(this->Run);
  Flags isChosen(parts.size(), 0);
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    isChosen[parts[i]] |= touched[i];
  }
  return this->where([&](std::size_t i) { return isChosen[parts[i]] != 0; });
}

std::vector<double> Chooser::curvatures()
{
  std::unique_ptr<RegionAdjacency> ofPoints;
  if (this->isOfTriangles())
  {
    ofPoints = std::make_unique<RegionAdjacency>(this->Mesh, RegionElements::points, this->Run);
  }
  const RegionAdjacency& adjacency = ofPoints ? *ofPoints : this->adjacency();
  const std::vector<Vec3>& points = this->Mesh.points;
  std::vector<double> atPoints(points.size());
  this->Run.parallelFor(points.size(), kFineGrain,
    [&](std::size_t begin, std::size_t end)
    {
      std::vector<Vec3> around;
      for (std::size_t i = begin; i < end; ++i)
      {
        around.clear();
        for (const Index other : adjacency.around(static_cast<Index>(i)))
        {
          around.push_back(points[other]);
        }
        atPoints[i] = meanCurvature(points[i], around);
      }
    });
  if (!this->isOfTriangles())
  {
    return atPoints;
  }
  std::vector<double> atTriangles;
  for (const auto& [a, b, c] : this->Mesh.triangles)
  {
    atTriangles.push_back((atPoints[a] + atPoints[b] + atPoints[c]) / 3.0);
  }
  return atTriangles;
}

std::vector<double> Chooser::values(const std::string& name)
{
  if (!this->Domain.valuesOf)
  {
    throw Error(ErrorCode::badParameter, "region: the model has no array " + name);
  }
  return this->Domain.valuesOf(name);
}

Index Chooser::nearestTo(const Vec3& point)
{
  Index nearest = 0;
  double best = std::numeric_limits<double>::infinity();
  for (Index i = 0; i < this->Places.size(); ++i)
  {
    const Vec3 d = this->Places[i] - point;
    double distance2 = dot(d, d);
    if (this->isOfTriangles())
    {
      const auto& [a, b, c] = this->Mesh.triangles[i];
      const std::vector<Vec3>& points = this->Mesh.points;
      distance2 = squaredDistance(point, points[a], points[b], points[c]);
    }
    if (distance2 < best)
    {
      best = distance2;
      nearest = i;
    }
  }
  return nearest;
}

double Chooser::radiusOf(const RegionRule& rule)
{
  return inModelUnits(rule.radius, this->Mesh.points, this->Domain.millimetresPerUnit);
}

const RegionAdjacency& Chooser::adjacency()
{
  if (!this->Adjacency)
  {
    this->Adjacency =
      std::make_unique<RegionAdjacency>(this->Mesh, this->Domain.elements, this->Run);
  }
  return *this->Adjacency;
}

} // namespace

std::vector<std::uint8_t> chooseElements(
  const RegionRule& rule, const RegionDomain& domain, Execution& execution)
{
  return Chooser(domain, execution).choose(rule);
}

} // namespace scan
