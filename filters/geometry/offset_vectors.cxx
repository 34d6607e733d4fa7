// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/offset_vectors.h"

#include "filters/geometry/incidence.h"
#include "filters/geometry/local_plane.h"
#include "filters/geometry/triangle_measures.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <span>

namespace scan
{
namespace
{

constexpr double kPreference = 1e-2; // of a direction, against a weight of all triangles of 1

using Vector = Eigen::Vector3d;

/// The least-squares sums of one point, of weight 1 in all; 0 without triangles.
struct Planes
{
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
  Vector sum = Vector::Zero();

  /// The vector that fits best, and near the preferred one where that is open.
  Vector nearTo(const Vector& preferred) const
  {
    const Eigen::Matrix3d all = this->matrix + kPreference * Eigen::Matrix3d::Identity();
    const Vector d = all.ldlt().solve(this->sum + kPreference * preferred);
    const double size = d.norm();
    return size > kLongestOffset ? Vector(d * (kLongestOffset / size)) : d;
  }
};

/// Which moves the planes best, of those straight along the mean normal.
Vector straightOffset(const Planes& planes, const Vector& anySide)
{
  const double size = planes.sum.norm();
  // two sides of a fold cancel each other: one of them has to do
  const Vector mean = size > 1e-9 ? Vector(planes.sum / size) : anySide;
  const double square = mean.dot(planes.matrix * mean);
  return square > 0.0 ? Vector(mean * (mean.dot(planes.sum) / square)) : Vector::Zero();
}

/// Of a point with these triangles.
Vector offsetOf(const TriMesh& mesh, Index point, std::span<const Index> triangles)
{
  Planes planes;
  double sum = 0.0;
  double heaviest = 0.0;
  Vector side = Vector::Zero();
  for (const Index t : triangles)
  {
    const Triangle& triangle = mesh.triangles[t];
    const auto corner =
      static_cast<std::size_t>(std::ranges::find(triangle, point) - triangle.begin());
    const Vec3 normal = normalOf(mesh.points, triangle);
    const double weight = normal != Vec3{} ? angleAt(mesh.points, triangle, corner) : 0.0;
    const Vector n(normal.x, normal.y, normal.z);
    planes.matrix += weight * n * n.transpose();
    planes.sum += weight * n;
    sum += weight;
    if (heaviest < weight)
    {
      heaviest = weight;
      side = n;
    }
  }
  if (!(sum > 0.0))
  {
    return Vector::Zero();
  }
  planes.matrix /= sum;
  planes.sum /= sum;
  return planes.nearTo(straightOffset(planes, side));
}

} // namespace

std::vector<Vec3> offsetVectors(const TriMesh& mesh, Execution& execution)
{
  const Incidence trianglesOf(mesh.points.size(), mesh.triangles.size(),
    [&](std::size_t t, auto&& visit) { std::ranges::for_each(mesh.triangles[t], visit); });
  std::vector<Vec3> vectors(mesh.points.size());
  execution.parallelFor(vectors.size(), 1 << 12,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        const auto point = static_cast<Index>(i);
        const Vector d = offsetOf(mesh, point, trianglesOf.of(point));
        vectors[i] = { d[0], d[1], d[2] };
      }
    });
  return vectors;
}

} // namespace scan
