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

/// The largest coordinates of some vectors, by axis, for error bounds.
struct Extent
{
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;

  void cover(const Vec3& v)
  {
    this->x = std::max(this->x, std::abs(v.x));
    this->y = std::max(this->y, std::abs(v.y));
    this->z = std::max(this->z, std::abs(v.z));
  }
  double volume() const { return this->x * this->y * this->z; }
  double largest() const { return std::max({ this->x, this->y, this->z }); }

  /// Above this no product of up to five coordinates loses digits by underflow that count.
  bool allowsFilter() const { return std::min({ this->x, this->y, this->z }) > 1e-50; }
};

/// Bounds for the determinants below as multiples of the extent's volume: number of roundings on
/// the longest path (8 and 17) times 2^-53 times number of monomials (6 and 24 times 3), and some.
inline constexpr double kVolumeError = 6e-15;
inline constexpr double kSphereError = 2e-13;

/// insideCircumsphere() without the filter.
bool insideCircumsphereExactly(const Corners& corners, const Vec3& p);

/// Is p inside the circumsphere of a positively oriented tetrahedron? A point on the sphere is
/// decided as if each point q had weight -eps(q), the lexicographically largest point having the
/// largest eps: exact, without ties, the same for any order of the corners. p is no corner.
/// Devillers, Teillaud, "Perturbations and vertex removal in a 3D Delaunay triangulation" (2003).
inline bool insideCircumsphere(const Corners& corners, const Vec3& p)
{
  const Vec3 a = *corners[0] - p;
  const Vec3 b = *corners[1] - p;
  const Vec3 c = *corners[2] - p;
  const Vec3 d = *corners[3] - p;
  Extent extent;
  extent.cover(a);
  extent.cover(b);
  extent.cover(c);
  extent.cover(d);

  const double ab = a.x * b.y - b.x * a.y;
  const double bc = b.x * c.y - c.x * b.y;
  const double cd = c.x * d.y - d.x * c.y;
  const double da = d.x * a.y - a.x * d.y;
  const double ac = a.x * c.y - c.x * a.y;
  const double bd = b.x * d.y - d.x * b.y;
  const double abc = a.z * bc - b.z * ac + c.z * ab;
  const double bcd = b.z * cd - c.z * bd + d.z * bc;
  const double cda = c.z * da + d.z * ac + a.z * cd;
  const double dab = d.z * ab + a.z * bd + b.z * da;
  const double outside = (dot(d, d) * abc - dot(c, c) * dab) + (dot(b, b) * cda - dot(a, a) * bcd);

  const double largest = extent.largest();
  const double error = kSphereError * extent.volume() * (largest * largest);
  if (std::abs(outside) > error && extent.allowsFilter())
  {
    return outside < 0.0;
  }
  return insideCircumsphereExactly(corners, p);
}

} // namespace scan
