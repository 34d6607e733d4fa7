// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/triangle_pair.h"

#include "filters/geometry/delaunay_predicates.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace scan
{
namespace
{

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

/// The exact side of d from the plane of abc.
int side(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
{
  const Vec3 u = a - d;
  const Vec3 v = b - d;
  const Vec3 w = c - d;
  const auto extent = [&](auto axis)
  { return std::max(std::max(std::abs(u.*axis), std::abs(v.*axis)), std::abs(w.*axis)); };
  const double x = extent(&Vec3::x);
  const double y = extent(&Vec3::y);
  const double z = extent(&Vec3::z);
  const double volume = -dot(u, cross(v, w));
  if (std::abs(volume) > kVolumeError * x * y * z && std::min(std::min(x, y), z) > kSmallestExtent)
  {
    return volume > 0.0 ? 1 : -1;
  }
  return orientation(a, b, c, d);
}

/// Points of a plane, seen along an axis.
class View
{
public:
  explicit View(int axis)
    : Axis(axis)
  {
  }

  /// A view in which the corners are not on a line.
  static View of(const Vec3& a, const Vec3& b, const Vec3& c)
  {
    for (const int axis : { 0, 1 })
    {
      if (View(axis).turn(a, b, c) != 0)
      {
        return View(axis);
      }
    }
    return View(2);
  }

  /// 1 for counter-clockwise, 0 for points on a line; exact.
  int turn(const Vec3& a, const Vec3& b, const Vec3& c) const
  {
    return static_cast<int>(CGAL::orientation(this->flat(a), this->flat(b), this->flat(c)));
  }

  /// Whether c, on the line through a and b, is not beyond either.
  bool isBetween(const Vec3& a, const Vec3& b, const Vec3& c) const
  {
    return CGAL::collinear_are_ordered_along_line(this->flat(a), this->flat(c), this->flat(b));
  }

private:
  Kernel::Point_2 flat(const Vec3& p) const
  {
    return this->Axis == 0 ? Kernel::Point_2(p.y, p.z)
      : this->Axis == 1    ? Kernel::Point_2(p.z, p.x)
                           : Kernel::Point_2(p.x, p.y);
  }

  int Axis;
};

bool segmentsMeet(const View& view, const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
{
  const int turnC = view.turn(a, b, c);
  const int turnD = view.turn(a, b, d);
  if (turnC == 0 && turnD == 0)
  {
    return view.isBetween(a, b, c) || view.isBetween(a, b, d) || view.isBetween(c, d, a);
  }
  return turnC * turnD <= 0 && view.turn(c, d, a) * view.turn(c, d, b) <= 0;
}

/// Segment pq and triangle abc, all in one plane.
bool meetsInPlane(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b, const Vec3& c)
{
  const View view = View::of(a, b, c);
  const int turn = view.turn(a, b, c);
  const bool isInside = view.turn(a, b, p) * turn >= 0 && view.turn(b, c, p) * turn >= 0 &&
    view.turn(c, a, p) * turn >= 0;
  return isInside || segmentsMeet(view, p, q, a, b) || segmentsMeet(view, p, q, b, c) ||
    segmentsMeet(view, p, q, c, a);
}

/// Whether segment pq and triangle abc have a point in common.
/// @param sideP of abc on which p is, and q
bool meets(
  const Vec3& p, const Vec3& q, int sideP, int sideQ, const Vec3& a, const Vec3& b, const Vec3& c)
{
  if (sideP * sideQ > 0)
  {
    return false;
  }
  if (sideP == 0 && sideQ == 0)
  {
    return meetsInPlane(p, q, a, b, c);
  }
  const int ab = side(p, q, a, b);
  const int bc = side(p, q, b, c);
  if (ab * bc < 0)
  {
    return false;
  }
  const int ca = side(p, q, c, a);
  return ab * ca >= 0 && bc * ca >= 0;
}

/// A triangle's corners, the shared ones first.
using Places = std::array<const Vec3*, 3>;

bool isOnOneSide(const std::array<int, 3>& sides)
{
  return sides[0] != 0 && sides[0] == sides[1] && sides[1] == sides[2];
}

/// Whether triangles without a common corner have a point in common: then an edge of one meets the
/// other.
bool meet(const Places& first, const Places& second)
{
  const auto sidesOf = [](const Places& of, const Places& from)
  {
    return std::array<int, 3>{ side(*from[0], *from[1], *from[2], *of[0]),
      side(*from[0], *from[1], *from[2], *of[1]), side(*from[0], *from[1], *from[2], *of[2]) };
  };
  const std::array<int, 3> firstSides = sidesOf(first, second);
  if (isOnOneSide(firstSides))
  {
    return false;
  }
  const std::array<int, 3> secondSides = sidesOf(second, first);
  if (isOnOneSide(secondSides))
  {
    return false;
  }
  for (std::size_t k = 0; k < 3; ++k)
  {
    const std::size_t next = (k + 1) % 3;
    if (meets(*first[k], *first[next], firstSides[k], firstSides[next], *second[0], *second[1],
          *second[2]) ||
      meets(*second[k], *second[next], secondSides[k], secondSides[next], *first[0], *first[1],
        *first[2]))
    {
      return true;
    }
  }
  return false;
}

/// Whether triangles with a common corner, their first, have another point in common: the ray to it
/// leaves one of them through the opposite edge.
bool meetBeyondCorner(const Places& first, const Places& second)
{
  const auto& [corner, a, b] = first;
  const int sideC = side(*corner, *a, *b, *second[1]);
  const int sideD = side(*corner, *a, *b, *second[2]);
  if (sideC * sideD > 0)
  {
    return false;
  }
  const int sideA = side(*corner, *second[1], *second[2], *a);
  const int sideB = side(*corner, *second[1], *second[2], *b);
  return sideA * sideB <= 0 &&
    (meets(*second[1], *second[2], sideC, sideD, *corner, *a, *b) ||
      meets(*a, *b, sideA, sideB, *corner, *second[1], *second[2]));
}

/// Whether triangles with a common edge, their first two corners, are folded onto each other.
bool areFolded(const Places& first, const Places& second)
{
  const auto& [a, b, c] = first;
  if (side(*a, *b, *c, *second[2]) != 0)
  {
    return false;
  }
  const View view = View::of(*a, *b, *c);
  return view.turn(*a, *b, *c) == view.turn(*a, *b, *second[2]);
}

} // namespace

bool meetBeyondShared(const TriMesh& mesh, const Triangle& first, const Triangle& second)
{
  Triangle t = first;
  Triangle u = second;
  std::size_t shared = 0;
  for (std::size_t k = 0; k < 3; ++k)
  {
    for (std::size_t other = shared; other < 3; ++other)
    {
      if (t[k] == u[other])
      {
        std::swap(t[k], t[shared]);
        std::swap(u[other], u[shared]);
        ++shared;
        break;
      }
    }
  }
  const auto at = [&](const Triangle& triangle) -> Places {
    return { &mesh.points[triangle[0]], &mesh.points[triangle[1]], &mesh.points[triangle[2]] };
  };
  switch (shared)
  {
    case 0:
      return meet(at(t), at(u));
    case 1:
      return meetBeyondCorner(at(t), at(u));
    case 2:
      return areFolded(at(t), at(u));
    default:
      return true;
  }
}

} // namespace scan
