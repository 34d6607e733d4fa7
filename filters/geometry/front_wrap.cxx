// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/front_wrap.h"

#include <CGAL/Advancing_front_surface_reconstruction.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <array>
#include <functional>
#include <iterator>
#include <tuple>
#include <utility>

namespace scan
{
namespace
{

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

/// The library's vertex under a name of our own, for the order of border edges below.
template <class Traits, class Base = CGAL::Triangulation_vertex_base_3<Traits>>
class FrontVertex : public CGAL::Advancing_front_surface_reconstruction_vertex_base_3<Traits, Base>
{
  using Super = CGAL::Advancing_front_surface_reconstruction_vertex_base_3<Traits, Base>;

public:
  template <class Structure>
  struct Rebind_TDS
  {
    using Other = FrontVertex<Traits, typename Base::template Rebind_TDS<Structure>::Other>;
  };
  using Super::Super;
};

using Triangulation = CGAL::Delaunay_triangulation_3<Kernel,
  CGAL::Triangulation_data_structure_3<FrontVertex<Kernel>,
    CGAL::Advancing_front_surface_reconstruction_cell_base_3<Kernel>>>;
using WaitingEdge = Triangulation::Vertex::Radius_ptr_type; ///< the value and the edge

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
} // namespace scan

/// Border edges of equal value come in the order of their points; the library takes that of their
/// places in memory, which differ from run to run.
template <>
struct std::less<scan::WaitingEdge>
{
  bool operator()(const scan::WaitingEdge& a, const scan::WaitingEdge& b) const
  {
    const auto key = [](const scan::WaitingEdge& edge)
    {
      const auto& [cell, i, j] = edge.second->first.first;
      return std::tuple(edge.first, cell->vertex(i)->id(), cell->vertex(j)->id());
    };
    return key(a) < key(b);
  }
};

namespace scan
{

std::vector<Triangle> frontWrap(std::span<const Vec3> points, Execution& execution)
{
  execution.step("front", 0, 3);
  constexpr std::size_t kLeastPoints = 3;
  if (points.size() < kLeastPoints)
  {
    return {};
  }
  std::vector<std::pair<Kernel::Point_3, std::size_t>> input;
  input.reserve(points.size());
  for (const Vec3& p : points)
  {
    input.emplace_back(Kernel::Point_3(p.x, p.y, p.z), input.size());
  }
  Triangulation triangulation(input.begin(), input.end());
  CGAL::Advancing_front_surface_reconstruction<Triangulation, CancellablePriority> front(
    triangulation, CancellablePriority(execution));
  front.run();
  std::vector<std::array<std::size_t, 3>> found;
  CGAL::write_triple_indices(std::back_inserter(found), front);
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
