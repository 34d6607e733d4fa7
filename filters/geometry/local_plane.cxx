// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/local_plane.h"

#include <Eigen/Eigenvalues>

#include <algorithm>

namespace scan
{

LocalPlane fitPlane(const Neighbours& places, std::span<const Neighbour> found)
{
  LocalPlane plane;
  if (found.empty())
  {
    return plane;
  }
  const double share = 1.0 / static_cast<double>(found.size());
  const Vec3 origin = places[found.front().place]; // far from 0 differences are more exact
  Vec3 middle;
  for (const Neighbour& neighbour : found)
  {
    middle = middle + (places[neighbour.place] - origin) * share;
  }
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Neighbour& neighbour : found)
  {
    const Vec3 d = places[neighbour.place] - origin - middle;
    const Eigen::Vector3d v(d.x, d.y, d.z);
    spread += share * v * v.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(spread);
  const auto column = [&](Eigen::Index i) -> Vec3
  {
    const auto v = solver.eigenvectors().col(i);
    return { v[0], v[1], v[2] };
  };
  plane.middle = origin + middle;
  plane.first = column(2);
  plane.second = column(1);
  for (Eigen::Index i = 0; i < 3; ++i)
  {
    plane.spread[static_cast<std::size_t>(i)] = std::max(0.0, solver.eigenvalues()[i]);
  }
  constexpr double kLine = 1e-12; // of the largest spread
  if (plane.spread[1] > kLine * plane.spread[2])
  {
    plane.normal = cross(plane.first, plane.second);
  }
  return plane;
}

} // namespace scan
