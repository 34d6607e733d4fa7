// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/mesh.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace scan
{

/// The corners of a tetrahedron.
using Corners = std::array<const Vec3*, 4>;

/// Exact sign of (b - a) x (c - a) . (d - a): 1, 0 or -1.
int orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// Exactly: are the points on a line?
bool collinear(const Vec3& a, const Vec3& b, const Vec3& c);

/// Bounds for determinants as multiples of the product of the largest coordinates by axis: number
/// of roundings on the longest path (8 and 17) times 2^-53 times number of monomials (6 and 24
/// times 3), and some.
inline constexpr double kVolumeError = 6e-15;
inline constexpr double kSphereError = 2e-13;

/// Above this no product of up to five coordinates loses digits by underflow that count.
inline constexpr double kSmallestExtent = 1e-50;

/// insideCircumsphere() without the filter.
bool insideCircumsphereExactly(const Corners& corners, const Vec3& p);

/// Two numbers in one register.
using Pair __attribute__((vector_size(16))) = double;

inline Pair swapped(Pair pair)
{
  return Pair{ pair[1], pair[0] };
}

inline Pair larger(Pair a, Pair b)
{
  return a > b ? a : b;
}

/// Is p inside the circumsphere of a positively oriented tetrahedron? A point on the sphere is
/// decided as if each point q had weight -eps(q), the lexicographically largest point having the
/// largest eps: exact, without ties, the same for any order of the corners. p is no corner.
/// Devillers, Teillaud, "Perturbations and vertex removal in a 3D Delaunay triangulation" (2003).
inline bool insideCircumsphere(
  const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& p)
{
  // with p as origin, a and c side by side, and b and d
  const Pair acX = Pair{ a.x, c.x } - p.x;
  const Pair acY = Pair{ a.y, c.y } - p.y;
  const Pair acZ = Pair{ a.z, c.z } - p.z;
  const Pair bdX = Pair{ b.x, d.x } - p.x;
  const Pair bdY = Pair{ b.y, d.y } - p.y;
  const Pair bdZ = Pair{ b.z, d.z } - p.z;
  // minors of two, three and four points
  const Pair abCd = acX * bdY - bdX * acY;
  const Pair bcDa = bdX * swapped(acY) - swapped(acX) * bdY;
  const Pair acBd = Pair{ acX[0], bdX[0] } * Pair{ acY[1], bdY[1] } -
    Pair{ acX[1], bdX[1] } * Pair{ acY[0], bdY[0] };
  const Pair abcCda = acZ * bcDa + swapped(acZ) * abCd + Pair{ -bdZ[0], bdZ[1] } * acBd[0];
  const Pair bcdDab = bdZ * swapped(abCd) + swapped(bdZ) * bcDa + Pair{ -acZ[1], acZ[0] } * acBd[1];
  const Pair acLift = acX * acX + acY * acY + acZ * acZ;
  const Pair bdLift = bdX * bdX + bdY * bdY + bdZ * bdZ;
  const Pair terms = swapped(bdLift) * abcCda - acLift * bcdDab;
  const double outside = terms[0] + terms[1];

  const auto extent = [](Pair v, Pair w)
  {
    const Pair both = larger(larger(v, -v), larger(w, -w));
    return std::max(both[0], both[1]);
  };
  const double x = extent(acX, bdX);
  const double y = extent(acY, bdY);
  const double z = extent(acZ, bdZ);
  const double largest = std::max({ x, y, z });
  const double error = kSphereError * x * y * z * (largest * largest);
  if (std::abs(outside) > error && std::min({ x, y, z }) > kSmallestExtent)
  {
    return outside < 0.0;
  }
  return insideCircumsphereExactly({ &a, &b, &c, &d }, p);
}

} // namespace scan
