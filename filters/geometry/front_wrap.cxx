// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/front_wrap.h"

#include <CGAL/Advancing_front_surface_reconstruction.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>

namespace scan
{
namespace
{

using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;

/// The library's default priority of a triangle, but never the same for two of them: between equal
/// ones it would decide by their places in memory, which differ from run to run. Asked for every
/// candidate: the place to cancel.
class DistinctPriority
{
public:
  explicit DistinctPriority(Execution& execution)
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
    constexpr double kTooSmallToSee = 1e-6; // relative
    return reconstruction.smallest_radius_delaunay_sphere(cell, index) *
      (1.0 + kTooSmallToSee * this->fraction(cell, index));
  }

private:
  /// A number from 0 to 1 that depends on the vertices of the triangle alone.
  template <class Cell>
  static double fraction(Cell& cell, int index)
  {
    std::array<std::uint64_t, 3> ids{};
    for (int k = 0; k < 3; ++k)
    {
      ids.at(static_cast<std::size_t>(k)) =
        static_cast<std::uint64_t>(cell->vertex((index + 1 + k) % 4)->id());
    }
    std::ranges::sort(ids);
    std::uint64_t mixed = 0;
    for (const std::uint64_t id : ids) // SplitMix64
    {
      mixed += id + 0x9e3779b97f4a7c15U;
      mixed = (mixed ^ (mixed >> 30U)) * 0xbf58476d1ce4e5b9U;
      mixed = (mixed ^ (mixed >> 27U)) * 0x94d049bb133111ebU;
      mixed ^= mixed >> 31U;
    }
    return static_cast<double>(mixed) * 0x1p-64;
  }

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
    input.begin(), input.end(), std::back_inserter(found), DistinctPriority(execution));
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
