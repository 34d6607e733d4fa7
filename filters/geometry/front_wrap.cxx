// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/front_wrap.h"

#include <CGAL/Advancing_front_surface_reconstruction.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <iterator>

namespace scan
{
namespace
{

using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;

/// The library's default priority of a triangle, asked for every candidate: the place to cancel.
class CancellablePriority
{
public:
  explicit CancellablePriority(Execution& execution)
    : Run(&execution)
  {
  }

  template <class Reconstruction, class Cell>
  double operator()(const Reconstruction& reconstruction, Cell& cell, int index) const
  {
    if (this->Run->cancelled())
    {
      this->Run->step("front", 1, 3); // throws
    }
    return reconstruction.smallest_radius_delaunay_sphere(cell, index);
  }

private:
  Execution* Run;
};

} // namespace

std::vector<Triangle> frontWrap(std::span<const Vec3> points, Execution& execution)
{
  execution.step("front", 0, 3);
  constexpr std::size_t kLeastPoints = 3;
  if (points.size() < kLeastPoints)
  {
    return {};
  }
  std::vector<Point> input;
  input.reserve(points.size());
  for (const Vec3& p : points)
  {
    input.emplace_back(p.x, p.y, p.z);
  }
  std::vector<std::array<std::size_t, 3>> found;
  CGAL::advancing_front_surface_reconstruction(
    input.begin(), input.end(), std::back_inserter(found), CancellablePriority(execution));
  execution.step("front", 2, 3);
  std::vector<Triangle> triangles;
  triangles.reserve(found.size());
  for (const auto& [a, b, c] : found)
  {
    triangles.push_back({ static_cast<Index>(a), static_cast<Index>(b), static_cast<Index>(c) });
  }
  execution.step("front", 3, 3);
  return triangles;
}

} // namespace scan
