// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/mean_curvature.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>

namespace scan
{
namespace
{

/// One row a point, without the heap.
constexpr int kMostPoints = 65;
template <int columns>
using Rows = Eigen::Matrix<double, Eigen::Dynamic, columns, 0, kMostPoints, columns>;

} // namespace

double meanCurvature(const Vec3& point, std::span<const Vec3> around)
{
  constexpr int kUnknowns = 6;
  around = around.first(std::min(around.size(), std::size_t{ kMostPoints - 1 }));
  const auto count = static_cast<Eigen::Index>(around.size()) + 1;
  double radius2 = 0.0;
  for (const Vec3& p : around)
  {
    radius2 = std::max(radius2, dot(p - point, p - point));
  }
  if (count <= kUnknowns || !(radius2 > 0.0))
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  // from the point, in units of the radius; the point itself is the last row
  const double radius = std::sqrt(radius2);
  Rows<3> local = Rows<3>::Zero(count, 3);
  for (Eigen::Index i = 0; i + 1 < count; ++i)
  {
    const Vec3 p = (around[static_cast<std::size_t>(i)] - point) * (1.0 / radius);
    local.row(i) << p.x, p.y, p.z;
  }
  const Rows<3> centred = local.rowwise() - local.colwise().mean();
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> spread;
  spread.computeDirect(centred.transpose() * centred);
  const Rows<3> seen = local * spread.eigenvectors(); // heights first: they spread least

  const auto x = seen.col(1).array();
  const auto y = seen.col(2).array();
  Rows<kUnknowns> terms(count, kUnknowns);
  terms << Rows<1>::Ones(count), x, y, x.square(), x * y, y.square();
  const Eigen::Matrix<double, kUnknowns, 1> fit =
    terms.completeOrthogonalDecomposition().solve(seen.col(0));
  const double slopeX = fit[1];
  const double slopeY = fit[2];
  const double twice = (1.0 + slopeY * slopeY) * 2.0 * fit[3] - 2.0 * slopeX * slopeY * fit[4] +
    (1.0 + slopeX * slopeX) * 2.0 * fit[5];
  return std::abs(twice) / (2.0 * std::pow(1.0 + slopeX * slopeX + slopeY * slopeY, 1.5)) / radius;
}

} // namespace scan
