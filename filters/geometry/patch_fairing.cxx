// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/patch_fairing.h"

#include "filters/geometry/half_edges.h"
#include "filters/geometry/local_plane.h"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>
#include <vector>

namespace scan
{
namespace
{

using Matrix = Eigen::SparseMatrix<double>;
using Entries = std::vector<Eigen::Triplet<double>>;

/// The cotangent of an angle, kept from what slivers have.
double cotangent(const Vec3& corner, const Vec3& a, const Vec3& b)
{
  constexpr double kMost = 10.0;
  const double sine = length(cross(a - corner, b - corner));
  const double cosine = dot(a - corner, b - corner);
  return std::abs(cosine) < kMost * sine ? cosine / sine : std::copysign(kMost, cosine);
}

/// Of a mesh, with areas about 1: the Laplacian without areas, and one over the areas of points.
struct Laplacian
{
  Matrix stiffness;
  Eigen::VectorXd inverseArea;
};

Laplacian laplacianOf(const TriMesh& mesh)
{
  const auto count = static_cast<Eigen::Index>(mesh.points.size());
  Eigen::VectorXd area = Eigen::VectorXd::Zero(count);
  Entries entries;
  entries.reserve(12 * mesh.triangles.size());
  for (const Triangle& t : mesh.triangles)
  {
    const Vec3& p = mesh.points[t[0]];
    const double third = length(cross(mesh.points[t[1]] - p, mesh.points[t[2]] - p)) / 6.0;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Index a = t[k];
      const Index b = t[(k + 1) % 3];
      area[a] += third;
      const double weight =
        cotangent(mesh.points[t[(k + 2) % 3]], mesh.points[a], mesh.points[b]) / 2.0;
      entries.emplace_back(a, b, -weight);
      entries.emplace_back(b, a, -weight);
      entries.emplace_back(a, a, weight);
      entries.emplace_back(b, b, weight);
    }
  }
  const double mean = std::max(area.mean(), 1e-300);
  Laplacian laplacian{ Matrix(count, count), Eigen::VectorXd(count) };
  laplacian.stiffness.setFromTriplets(entries.begin(), entries.end());
  constexpr double kLeastArea = 0.01; // of the mean
  for (Eigen::Index i = 0; i < count; ++i)
  {
    laplacian.inverseArea[i] = 1.0 / std::max(area[i] / mean, kLeastArea);
  }
  return laplacian;
}

/// The rows of a matrix that stand for free points, in their order.
Matrix freeRows(const Matrix& matrix, std::span<const Index> free)
{
  Entries entries;
  for (Eigen::Index i = 0; i < static_cast<Eigen::Index>(free.size()); ++i)
  {
    entries.emplace_back(i, free[static_cast<std::size_t>(i)], 1.0);
  }
  Matrix pick(static_cast<Eigen::Index>(free.size()), matrix.rows());
  pick.setFromTriplets(entries.begin(), entries.end());
  return pick * matrix;
}

} // namespace

void fairPoints(
  TriMesh& mesh, std::span<const std::uint8_t> isFree, int power, Execution& execution)
{
  std::vector<Index> free;
  for (Index i = 0; i < mesh.points.size(); ++i)
  {
    if (isFree[i] != 0)
    {
      free.push_back(i);
    }
  }
  if (free.empty())
  {
    return;
  }
  execution.step("", 0, 1); // for a cancel
  const Laplacian laplacian = laplacianOf(mesh);
  Matrix rows = freeRows(laplacian.stiffness, free);
  for (int i = 1; i < power; ++i)
  {
    rows = (rows * laplacian.inverseArea.asDiagonal() * laplacian.stiffness).eval();
  }
  // what the fixed points contribute, around a point nearby so that nothing is lost by rounding
  const Vec3 origin = mesh.points[free.front()];
  Eigen::MatrixX3d fixed = Eigen::MatrixX3d::Zero(rows.cols(), 3);
  for (Index i = 0; i < mesh.points.size(); ++i)
  {
    if (isFree[i] == 0)
    {
      const Vec3 p = mesh.points[i] - origin;
      fixed.row(i) << p.x, p.y, p.z;
    }
  }
  const Eigen::MatrixX3d right = -(rows * fixed);
  const Matrix system = freeRows(Matrix(rows.transpose()), free);
  execution.step("", 0, 1);
  const Eigen::SimplicialLDLT<Matrix> solver(system);
  if (solver.info() != Eigen::Success)
  {
    return;
  }
  const Eigen::MatrixX3d solution = solver.solve(right);
  if (!solution.allFinite())
  {
    return;
  }
  for (std::size_t i = 0; i < free.size(); ++i)
  {
    const auto row = static_cast<Eigen::Index>(i);
    mesh.points[free[i]] = origin + Vec3{ solution(row, 0), solution(row, 1), solution(row, 2) };
  }
}

} // namespace scan
