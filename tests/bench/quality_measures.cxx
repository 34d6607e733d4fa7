// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/quality_measures.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace quality
{
namespace
{

using scan::TriMesh;
using scan::Vec3;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triangles = std::vector<Kernel::Triangle_3>;

constexpr std::size_t kSamples = 100000;

Kernel::Point_3 cgalPoint(const Vec3& p)
{
  return { p.x, p.y, p.z };
}

/// Exact distances to a triangle mesh.
class SurfaceDistance
{
public:
  explicit SurfaceDistance(const TriMesh& mesh)
    : Flat(nonFlat(mesh))
    , Tree(this->Flat.begin(), this->Flat.end())
  {
    this->Tree.accelerate_distance_queries();
  }

  double operator()(const Vec3& p) const
  {
    return std::sqrt(this->Tree.squared_distance(cgalPoint(p)));
  }

private:
  using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;

  static Triangles nonFlat(const TriMesh& mesh)
  {
    Triangles triangles;
    triangles.reserve(mesh.triangles.size());
    for (const auto& [a, b, c] : mesh.triangles)
    {
      const Kernel::Triangle_3 triangle(
        cgalPoint(mesh.points[a]), cgalPoint(mesh.points[b]), cgalPoint(mesh.points[c]));
      if (!triangle.is_degenerate())
      {
        triangles.push_back(triangle);
      }
    }
    return triangles;
  }

  Triangles Flat;
  CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>> Tree;
};

Deviation deviation(std::span<const Vec3> points, const SurfaceDistance& distance, double unit)
{
  Deviation result;
  for (const Vec3& p : points)
  {
    const double d = distance(p) / unit;
    result.mean += d / static_cast<double>(points.size());
    result.max = std::max(result.max, d);
  }
  return result;
}

double area(const TriMesh& mesh, const scan::Triangle& triangle)
{
  const Vec3& a = mesh.points[triangle[0]];
  const Vec3 normal = cross(mesh.points[triangle[1]] - a, mesh.points[triangle[2]] - a);
  return 0.5 * std::sqrt(dot(normal, normal));
}

/// Places on the surface, even by area: triangle by triangle along a sequence of low discrepancy.
std::vector<Vec3> sampleSurface(const TriMesh& mesh)
{
  std::vector<double> areaUpTo;
  double total = 0.0;
  for (const scan::Triangle& triangle : mesh.triangles)
  {
    areaUpTo.push_back(total += area(mesh, triangle));
  }
  std::vector<Vec3> samples;
  std::size_t at = 0;
  for (std::size_t i = 0; i < kSamples; ++i)
  {
    const auto step = static_cast<double>(i);
    while (at + 1 < areaUpTo.size() && areaUpTo[at] < (step + 0.5) / kSamples * total)
    {
      ++at;
    }
    double u = std::fmod(step * 0.7548776662466927, 1.0); // Roberts' R2 sequence
    double v = std::fmod(step * 0.5698402909980532, 1.0);
    if (u + v > 1.0)
    {
      u = 1.0 - u;
      v = 1.0 - v;
    }
    const auto& [a, b, c] = mesh.triangles[at];
    samples.push_back(mesh.points[a] * (1.0 - u - v) + mesh.points[b] * u + mesh.points[c] * v);
  }
  return samples;
}

std::vector<Vec3> corners(const TriMesh& mesh)
{
  std::vector<bool> used(mesh.points.size());
  for (const scan::Triangle& triangle : mesh.triangles)
  {
    for (const scan::Index corner : triangle)
    {
      used[corner] = true;
    }
  }
  std::vector<Vec3> result;
  for (std::size_t i = 0; i < used.size(); ++i)
  {
    if (used[i])
    {
      result.push_back(mesh.points[i]);
    }
  }
  return result;
}

Deviation surfaceDeviation(const TriMesh& mesh, const SurfaceDistance& distance, double unit)
{
  Deviation result = deviation(sampleSurface(mesh), distance, unit);
  result.max = std::max(result.max, deviation(corners(mesh), distance, unit).max);
  return result;
}

bool before(const Vec3& a, const Vec3& b)
{
  return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
}

std::vector<Vec3> distinct(std::vector<Vec3> points)
{
  std::sort(points.begin(), points.end(), before);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

double shareOnSurface(const TriMesh& surface, std::span<const Vec3> points)
{
  const std::vector<Vec3> all = distinct({ points.begin(), points.end() });
  const std::vector<Vec3> used = distinct(corners(surface));
  std::vector<Vec3> both;
  std::set_intersection(
    all.begin(), all.end(), used.begin(), used.end(), std::back_inserter(both), before);
  return static_cast<double>(both.size()) / static_cast<double>(all.size());
}

} // namespace

Quality measureQuality(
  const TriMesh& surface, std::span<const Vec3> points, const TriMesh* truth, double unit)
{
  const SurfaceDistance distance(surface);
  Quality quality;
  quality.pointsOnSurface = shareOnSurface(surface, points);
  quality.ofPoints = deviation(points, distance, unit);
  quality.topology = scan::describeMesh(surface);
  if (truth != nullptr)
  {
    quality.fromTruth = surfaceDeviation(surface, SurfaceDistance(*truth), unit);
    quality.ofTruth = surfaceDeviation(*truth, distance, unit);
  }
  return quality;
}

} // namespace quality
