// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/delaunay_predicates.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <tuple>

namespace scan
{
namespace
{

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

Kernel::Point_3 at(const Vec3& p)
{
  return { p.x, p.y, p.z };
}

/// p lies on the sphere: the largest point whose weight matters decides. That of p puts p outside;
/// that of a corner puts p inside where p is on the corner's side of the opposite facet.
bool insideAfterPerturbation(const Corners& corners, const Vec3& p)
{
  std::array<const Vec3*, 5> largestFirst{ corners[0], corners[1], corners[2], corners[3], &p };
  std::sort(largestFirst.begin(), largestFirst.end(),
    [](const Vec3* a, const Vec3* b)
    { return std::tie(a->x, a->y, a->z) > std::tie(b->x, b->y, b->z); });
  for (const Vec3* weighted : largestFirst)
  {
    Corners replaced = corners;
    const auto corner = std::find(replaced.begin(), replaced.end(), weighted);
    if (corner == replaced.end())
    {
      return false;
    }
    *corner = &p;
    const int side = orientation(*replaced[0], *replaced[1], *replaced[2], *replaced[3]);
    if (side != 0)
    {
      return side > 0;
    }
  }
  return false;
}

} // namespace

int orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
{
  return static_cast<int>(CGAL::orientation(at(a), at(b), at(c), at(d)));
}

bool collinear(const Vec3& a, const Vec3& b, const Vec3& c)
{
  return CGAL::collinear(at(a), at(b), at(c));
}

bool insideCircumsphereExactly(const Corners& corners, const Vec3& p)
{
  const CGAL::Oriented_side side = CGAL::side_of_oriented_sphere(
    at(*corners[0]), at(*corners[1]), at(*corners[2]), at(*corners[3]), at(p));
  return side == CGAL::ON_ORIENTED_BOUNDARY ? insideAfterPerturbation(corners, p)
                                            : side == CGAL::ON_POSITIVE_SIDE;
}

} // namespace scan
