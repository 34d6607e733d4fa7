// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/hole_patch.h"

#include "filters/geometry/local_plane.h"
#include "filters/geometry/patch_fairing.h"
#include "filters/geometry/triangle_measures.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace scan
{
namespace
{

constexpr double kManyPoints = 20000.0; // of a patch, beyond which its edges grow inwards
constexpr double kGrowth = 0.25;
constexpr int kFairings = 3; // each with the weights of the shape before

double areaOf(const TriMesh& mesh)
{
  double area = 0.0;
  for (const Triangle& t : mesh.triangles)
  {
    area += areaOf(mesh.points, t);
  }
  return area;
}

/// How much the spacing of a patch must grow inwards so that the points do not get too many.
double growthOf(const Patch& patch)
{
  double sum = 0.0;
  for (const double spacing : patch.spacing)
  {
    sum += spacing;
  }
  const double mean = sum / static_cast<double>(patch.spacing.size());
  constexpr double kAreaPerPoint = 0.866; // of equilateral triangles with edges of length 1
  return areaOf(patch.mesh) > kManyPoints * kAreaPerPoint * mean * mean ? kGrowth : 0.0;
}

} // namespace

HoledSurface::HoledSurface(const TriMesh& mesh, const std::vector<HolePolygon>& holes)
  : Mesh(mesh)
  , Around(mesh.points.size(), mesh.triangles.size(),
      [&](std::size_t t, auto&& visit) { std::ranges::for_each(mesh.triangles[t], visit); })
{
  std::vector<std::uint8_t> isRim(mesh.points.size(), 0);
  for (const HolePolygon& hole : holes)
  {
    for (const Index point : hole.points)
    {
      isRim[point] = 1;
    }
  }
  for (const Triangle& t : mesh.triangles)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Index a = t[k];
      const Index b = t[(k + 1) % 3];
      if (isRim[a] != 0 && isRim[b] != 0)
      {
        this->taken.add(a, b);
      }
    }
  }
}

Vec3 HoledSurface::normalOf(Index triangle) const
{
  return triangle == kNone ? Vec3{}
                           : scan::normalOf(this->Mesh.points, this->Mesh.triangles[triangle]);
}

/// The mean length of the edges at a point.
double HoledSurface::spacingAt(Index point) const
{
  double sum = 0.0;
  double edges = 0.0;
  for (const Index triangle : this->Around.of(point))
  {
    for (const Index other : this->Mesh.triangles[triangle])
    {
      if (other != point)
      {
        sum += length(this->Mesh.points[other] - this->Mesh.points[point]);
        edges += 1.0;
      }
    }
  }
  return edges > 0.0 ? sum / edges : 0.0;
}

std::optional<Patch> HoledSurface::triangulated(std::vector<Vec3> corners, std::vector<Index> names,
  std::span<const Index> beyond, LoopAim aim, Execution& execution) const
{
  SpaceLoop loop{ std::move(corners), {}, std::move(names) };
  for (const Index triangle : beyond)
  {
    loop.normals.push_back(this->normalOf(triangle));
  }
  auto triangles = triangulateLoop(loop, aim, this->taken, execution);
  if (!triangles)
  {
    return std::nullopt;
  }
  return Patch{ { std::move(loop.corners), std::move(*triangles) }, std::move(loop.names), {} };
}

std::optional<Patch> HoledSurface::flatPatch(
  const HolePolygon& hole, LoopAim aim, Execution& execution) const
{
  std::vector<Vec3> corners;
  for (const Index point : hole.points)
  {
    corners.push_back(this->Mesh.points[point]);
  }
  return this->triangulated(std::move(corners), hole.points, hole.beyond, aim, execution);
}

std::optional<Patch> HoledSurface::smoothPatch(
  const HolePolygon& hole, FillShape shape, Execution& execution) const
{
  std::vector<Vec3> corners;
  std::vector<Index> names;
  std::vector<Index> beyond;
  std::vector<double> spacing;
  auto fresh = static_cast<Index>(this->Mesh.points.size());
  for (std::size_t i = 0; i < hole.points.size(); ++i)
  {
    const Index point = hole.points[i];
    const Vec3& at = this->Mesh.points[point];
    corners.push_back(at);
    names.push_back(point);
    beyond.push_back(hole.beyond[i]);
    spacing.push_back(this->spacingAt(point));
    if (hole.beyond[i] == kNone) // the chord
    {
      const Index next = hole.points[(i + 1) % hole.points.size()];
      const double here = spacing.back();
      const double there = this->spacingAt(next);
      const Vec3 along = this->Mesh.points[next] - at;
      constexpr double kMostParts = 1000.0;
      const double parts =
        std::clamp(std::round(2.0 * length(along) / (here + there)), 1.0, kMostParts);
      for (double k = 1.0; k < parts; k += 1.0)
      {
        corners.push_back(at + along * (k / parts));
        names.push_back(fresh++);
        beyond.push_back(kNone);
        spacing.push_back(here + (there - here) * (k / parts));
      }
    }
  }
  auto patch =
    this->triangulated(std::move(corners), std::move(names), beyond, LoopAim::fold, execution);
  if (!patch)
  {
    return std::nullopt;
  }
  patch->spacing = std::move(spacing);
  refinePatch(*patch, growthOf(*patch), this->taken, execution);
  for (int i = 0; i < kFairings; ++i)
  {
    evenOut(*patch);
    flipEdges(*patch, this->taken, execution);
    this->fair(shape == FillShape::curved ? 3 : 2, *patch, execution);
  }
  return patch;
}

/// Fairs the points within, together with the surface around.
void HoledSurface::fair(int power, Patch& patch, Execution& execution) const
{
  TriMesh local = patch.mesh;
  std::unordered_map<Index, Index> numbers; // of points of the mesh in `local`
  std::vector<Index> reached;
  for (Index i = 0; i < patch.rim(); ++i)
  {
    if (patch.names[i] < this->Mesh.points.size())
    {
      numbers[patch.names[i]] = i;
      reached.push_back(patch.names[i]);
    }
  }
  std::vector<Index> triangles;
  for (int ring = 1; ring < power; ++ring)
  {
    for (const Index point : reached)
    {
      const auto around = this->Around.of(point);
      triangles.insert(triangles.end(), around.begin(), around.end());
    }
    std::ranges::sort(triangles);
    triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
    reached.clear();
    for (const Index triangle : triangles)
    {
      for (const Index point : this->Mesh.triangles[triangle])
      {
        if (numbers.try_emplace(point, static_cast<Index>(local.points.size())).second)
        {
          local.points.push_back(this->Mesh.points[point]);
          reached.push_back(point);
        }
      }
    }
  }
  for (const Index triangle : triangles)
  {
    const Triangle& t = this->Mesh.triangles[triangle];
    local.triangles.push_back({ numbers[t[0]], numbers[t[1]], numbers[t[2]] });
  }
  std::vector<std::uint8_t> isFree(local.points.size(), 0);
  std::fill(isFree.begin() + patch.rim(),
    isFree.begin() + static_cast<std::ptrdiff_t>(patch.mesh.points.size()), std::uint8_t{ 1 });
  fairPoints(local, isFree, power, execution);
  std::copy_n(local.points.begin(), patch.mesh.points.size(), patch.mesh.points.begin());
}

} // namespace scan
