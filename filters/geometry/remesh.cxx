// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/remesh.h"

#include "filters/base/error.h"
#include "filters/geometry/finite_points.h"
#include "filters/geometry/half_edges.h"
#include "filters/geometry/isotropic_remesher.h"
#include "filters/geometry/local_plane.h"
#include "filters/geometry/mesh_split.h"
#include "filters/geometry/replaced_triangles.h"
#include "filters/geometry/self_intersections.h"
#include "filters/geometry/surface_deviation.h"
#include "filters/geometry/triangle_measures.h"
#include "filters/geometry/used_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

namespace scan
{
namespace
{

constexpr std::size_t kTries = 10;  // before all of the region is held back
constexpr std::size_t kShorter = 4; // of these at most, to make edges shorter
constexpr double kShorterBy = 0.7;
constexpr std::size_t kMany = 20; // one of so many triangles is bad: the edges are too long
constexpr double kMostTriangles = 5e7;

/// How much each corner of a triangle counts at a place on it.
std::array<double, 3> weightsAt(const TriMesh& mesh, const Triangle& t, const Vec3& place)
{
  std::array<double, 3> weights{};
  double sum = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Vec3& a = mesh.points[t[(k + 1) % 3]];
    const Vec3& b = mesh.points[t[(k + 2) % 3]];
    weights.at(k) = length(cross(a - place, b - place));
    sum += weights.at(k);
  }
  if (!(sum > 0.0))
  {
    return { 1.0, 0.0, 0.0 };
  }
  std::ranges::for_each(weights, [&](double& weight) { weight /= sum; });
  return weights;
}

/// A triangle's place in a try.
enum class Part : std::uint8_t
{
  outside,
  held,
  remeshed
};

class Remesher
{
public:
  Remesher(const TriMesh& mesh, std::span<const std::uint8_t> inRegion,
    const RemeshOptions& options, Execution& execution);

  RemeshResult run();

private:
  void holdBackBadPlaces();
  void measureRegion();
  void tryOnce(std::size_t attempt);
  void blendNewPoints();
  std::vector<Index> badInputTriangles();
  void holdBack(const std::vector<Index>& triangles, std::size_t rings);
  void describeNew();

  const TriMesh& Mesh;
  RemeshOptions Options;
  Execution& Run;
  EdgePairs Pairs;
  TriangleTree Tree;
  std::vector<Part> Parts;
  RemeshResult Result;
  double LeastEdgeLength = 0.0;
  Index FirstNew = 0; // triangle
};

Remesher::Remesher(const TriMesh& mesh, std::span<const std::uint8_t> inRegion,
  const RemeshOptions& options, Execution& execution)
  : Mesh(mesh)
  , Options(options)
  , Run(execution)
  , Pairs(pairEdges(mesh, execution))
  , Tree(mesh, execution)
  , Parts(mesh.triangles.size())
{
  std::ranges::transform(inRegion, this->Parts.begin(),
    [](std::uint8_t is) { return is != 0 ? Part::remeshed : Part::outside; });
}

/// What is no manifold, intersects itself or has no area, and what touches it by a point.
void Remesher::holdBackBadPlaces()
{
  std::vector<Index> bad;
  for (Index t = 0; t < this->Mesh.triangles.size(); ++t)
  {
    if (isCollapsed(this->Mesh.triangles[t]) ||
      !(areaOf(this->Mesh.points, this->Mesh.triangles[t]) > 0.0))
    {
      bad.push_back(t);
    }
  }
  for (const Index half : this->Pairs.crowded)
  {
    bad.push_back(half / 3);
  }
  for (const Index half : this->Pairs.misoriented)
  {
    bad.push_back(half / 3);
    bad.push_back(this->Pairs.mate[half] / 3);
  }
  const SplitResult split = splitNonManifold(this->Mesh, this->Pairs, this->Run);
  for (Index t = 0; t < this->Mesh.triangles.size(); ++t)
  {
    if (split.mesh.triangles[t] != this->Mesh.triangles[t])
    {
      bad.push_back(t);
    }
  }
  std::vector<Index> region;
  for (Index t = 0; t < this->Parts.size(); ++t)
  {
    if (this->Parts[t] == Part::remeshed)
    {
      region.push_back(t);
    }
  }
  for (const TrianglePair& pair : selfIntersections(this->Mesh, region, this->Run))
  {
    bad.insert(bad.end(), pair.begin(), pair.end());
  }
  this->holdBack(bad, 1);
}

/// Takes triangles out of what is remeshed, and those around, ring by ring.
void Remesher::holdBack(const std::vector<Index>& triangles, std::size_t rings)
{
  std::vector<std::uint8_t> isBad(this->Mesh.points.size(), 0);
  const auto mark = [&](Index t)
  {
    for (const Index point : this->Mesh.triangles[t])
    {
      isBad[point] = 1;
    }
    this->Parts[t] = this->Parts[t] == Part::remeshed ? Part::held : this->Parts[t];
  };
  std::ranges::for_each(triangles, mark);
  for (std::size_t ring = 0; ring < rings && !triangles.empty(); ++ring)
  {
    std::vector<Index> touching;
    for (Index t = 0; t < this->Mesh.triangles.size(); ++t)
    {
      if (std::ranges::any_of(
            this->Mesh.triangles[t], [&](Index point) { return isBad[point] != 0; }))
      {
        touching.push_back(t);
      }
    }
    std::ranges::for_each(touching, mark);
  }
}

void Remesher::measureRegion()
{
  double sum = 0.0;
  double edges = 0.0;
  double area = 0.0;
  for (Index t = 0; t < this->Mesh.triangles.size(); ++t)
  {
    if (this->Parts[t] == Part::outside)
    {
      continue;
    }
    const Triangle& corners = this->Mesh.triangles[t];
    area += areaOf(this->Mesh.points, corners);
    for (std::size_t k = 0; k < 3; ++k)
    {
      sum += length(this->Mesh.points[corners[(k + 1) % 3]] - this->Mesh.points[corners[k]]);
      edges += 1.0;
    }
  }
  double& edgeLength = this->Options.edgeLength;
  edgeLength = edgeLength > 0.0 ? edgeLength : edges > 0.0 ? sum / edges : 0.0;
  constexpr double kEquilateral = 0.433; // the area for an edge of length 1
  this->LeastEdgeLength = std::sqrt(area / (kMostTriangles * kEquilateral));
  if (edgeLength < this->LeastEdgeLength)
  {
    throw Error(ErrorCode::badParameter,
      "edges that short would make more than 50 million triangles; choose longer ones");
  }
}

void Remesher::tryOnce(std::size_t attempt)
{
  TriMesh inside{ this->Mesh.points, {} };
  std::vector<std::uint8_t> isBoundary; // per half-edge
  bool isAll = true;
  for (Index t = 0; t < this->Parts.size(); ++t)
  {
    if (this->Parts[t] != Part::remeshed)
    {
      isAll = false;
      continue;
    }
    inside.triangles.push_back(this->Mesh.triangles[t]);
    for (Index k = 0; k < 3; ++k)
    {
      isBoundary.push_back(this->Pairs.mate[3 * t + k] == kNone ? 1 : 0);
    }
  }
  std::vector<Index> origins;
  TriMesh made;
  if (!inside.triangles.empty())
  {
    const std::vector<Index> kept = dropUnusedPoints(inside);
    const SplitResult split = splitNonManifold(std::move(inside), this->Run);
    IsotropicRemesher remesher(split.mesh, isBoundary,
      { this->Options.edgeLength, this->Options.keepFeatures, !isAll }, this->Tree);
    const auto iterations = static_cast<std::size_t>(this->Options.iterations);
    for (std::size_t i = 0; i < iterations; ++i)
    {
      this->Run.step("remesh", attempt == 0 ? i : iterations, iterations);
      remesher.iterate();
    }
    made = remesher.mesh(origins);
    for (Index& origin : origins)
    {
      origin = origin == kNone ? kNone : kept[split.pointOrigin[origin]];
    }
  }
  this->Run.step("remesh", 1, 1);
  std::vector<std::uint8_t> isReplaced(this->Parts.size());
  std::ranges::transform(
    this->Parts, isReplaced.begin(), [](Part part) { return part == Part::remeshed ? 1 : 0; });
  this->Result.edit = replaceTriangles(this->Mesh, isReplaced, made, origins);
  this->FirstNew = static_cast<Index>(this->Result.edit.triangleOrigin.size());
}

/// The input triangles where the result is not as promised.
std::vector<Index> Remesher::badInputTriangles()
{
  const TriMesh& after = this->Result.edit.mesh;
  std::vector<Index> fresh(after.triangles.size() - this->FirstNew);
  std::iota(fresh.begin(), fresh.end(), this->FirstNew);
  std::vector<Index> bad; // triangles of the result
  for (const TrianglePair& pair : selfIntersections(after, fresh, this->Run))
  {
    bad.insert(bad.end(), pair.begin(), pair.end());
  }
  for (const Index t : fresh)
  {
    if (!(areaOf(after.points, after.triangles[t]) > 0.0))
    {
      bad.push_back(t);
    }
  }
  const EdgePairs pairs = pairEdges(after, this->Run);
  for (const Index half : pairs.crowded)
  {
    bad.push_back(half / 3);
  }
  std::vector<Index> badInput;
  if (this->Options.maxDeviation < std::numeric_limits<double>::infinity() && !fresh.empty())
  {
    const auto beyond = trianglesBeyond(after, this->Tree, this->Options.maxDeviation, this->Run);
    bad.insert(bad.end(), beyond.begin(), beyond.end());
    const TriangleTree tree(after, this->Run);
    badInput = trianglesBeyond(this->Mesh, tree, this->Options.maxDeviation, this->Run);
  }
  std::erase_if(bad, [&](Index t) { return t < this->FirstNew; });
  for (const Index t : bad)
  {
    Vec3 middle;
    for (const Index point : after.triangles[t])
    {
      middle = middle + after.points[point] * (1.0 / 3.0);
      badInput.push_back(this->Tree.nearest(after.points[point]).triangle);
    }
    badInput.push_back(this->Tree.nearest(middle).triangle);
  }
  return badInput;
}

/// Data of new parts are those of the nearest places of the input.
void Remesher::blendNewPoints()
{
  SurfaceEdit& edit = this->Result.edit;
  for (std::size_t i = 0; i < edit.mesh.points.size(); ++i)
  {
    if (edit.pointOrigin[i] == kNone)
    {
      const SurfacePlace place = this->Tree.nearest(edit.mesh.points[i]);
      const Triangle& corners = this->Mesh.triangles[place.triangle];
      edit.blends.push_back({ corners, weightsAt(this->Mesh, corners, place.point) });
    }
  }
  for (Index t = this->FirstNew; t < edit.mesh.triangles.size(); ++t)
  {
    Vec3 middle;
    for (const Index point : edit.mesh.triangles[t])
    {
      middle = middle + edit.mesh.points[point] * (1.0 / 3.0);
    }
    edit.triangleOrigin.push_back(this->Tree.nearest(middle).triangle);
  }
}

void Remesher::describeNew()
{
  const TriMesh& mesh = this->Result.edit.mesh;
  const double aim = this->Options.edgeLength;
  double edges = 0.0;
  double good = 0.0;
  double least = std::numbers::pi;
  for (Index t = this->FirstNew; t < mesh.triangles.size(); ++t)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Triangle& corners = mesh.triangles[t];
      const Vec3 along = mesh.points[corners[(k + 1) % 3]] - mesh.points[corners[k]];
      const Vec3 back = mesh.points[corners[(k + 2) % 3]] - mesh.points[corners[k]];
      const double ratio = length(along) / aim;
      edges += 1.0;
      good += ratio >= 4.0 / 5.0 && ratio <= 4.0 / 3.0 ? 1.0 : 0.0;
      least = std::min(least, std::atan2(length(cross(along, back)), dot(along, back)));
    }
  }
  this->Result.made = static_cast<Index>(mesh.triangles.size()) - this->FirstNew;
  this->Result.goodEdges = edges > 0.0 ? good / edges : 0.0;
  this->Result.leastAngle = edges > 0.0 ? least * 180.0 / std::numbers::pi : 0.0;
  this->Result.heldBack = static_cast<Index>(std::ranges::count(this->Parts, Part::held));
}

RemeshResult Remesher::run()
{
  this->measureRegion();
  this->holdBackBadPlaces();
  const bool isLimited = this->Options.maxDeviation < std::numeric_limits<double>::infinity();
  for (std::size_t attempt = 0;; ++attempt)
  {
    this->tryOnce(attempt);
    this->Run.step("check", attempt, kTries + 1);
    std::vector<Index> bad = this->badInputTriangles();
    std::ranges::sort(bad);
    bad.erase(std::unique(bad.begin(), bad.end()), bad.end());
    if (bad.empty())
    {
      break;
    }
    const auto remeshed = static_cast<std::size_t>(std::ranges::count(this->Parts, Part::remeshed));
    const double shorter = this->Options.edgeLength * kShorterBy;
    if (attempt < kShorter && isLimited && shorter > this->LeastEdgeLength &&
      kMany * bad.size() > remeshed)
    {
      this->Options.edgeLength = shorter;
      continue;
    }
    this->holdBack(bad, 1 + attempt / 2);
    if (attempt + 1 == kTries)
    {
      std::ranges::replace(this->Parts, Part::remeshed, Part::held);
    }
  }
  this->Result.edgeLength = this->Options.edgeLength;
  this->blendNewPoints();
  this->describeNew();
  this->Run.step("check", 1, 1);
  return std::move(this->Result);
}

} // namespace

RemeshResult remesh(const TriMesh& mesh, std::span<const std::uint8_t> inRegion,
  const RemeshOptions& options, Execution& execution)
{
  execution.step("remesh", 0, 1);
  requireFinitePoints(mesh.points);
  if (mesh.triangles.empty())
  {
    return { unchanged(mesh) };
  }
  return Remesher(mesh, inRegion, options, execution).run();
}

} // namespace scan
