// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/mesh.h"

#include <cmath>

namespace scan
{

/// A weighted sum of squared distances from planes, x' A x + 2 b' x + c (Garland, Heckbert 1997).
struct Quadric
{
  double xx = 0.0, xy = 0.0, xz = 0.0, yy = 0.0, yz = 0.0, zz = 0.0; ///< A
  Vec3 b;
  double c = 0.0;

  /// The plane through `at` with a unit normal.
  static Quadric plane(const Vec3& normal, const Vec3& at, double weight)
  {
    const Vec3 n = normal * weight;
    const double d = -dot(normal, at);
    return { n.x * normal.x, n.x * normal.y, n.x * normal.z, n.y * normal.y, n.y * normal.z,
      n.z * normal.z, n * d, weight * d * d };
  }

  Quadric& operator+=(const Quadric& q)
  {
    this->xx += q.xx;
    this->xy += q.xy;
    this->xz += q.xz;
    this->yy += q.yy;
    this->yz += q.yz;
    this->zz += q.zz;
    this->b = this->b + q.b;
    this->c += q.c;
    return *this;
  }

  /// The sum of the weights, when all normals are of length 1.
  double weight() const { return this->xx + this->yy + this->zz; }

  Vec3 times(const Vec3& x) const
  {
    return { this->xx * x.x + this->xy * x.y + this->xz * x.z,
      this->xy * x.x + this->yy * x.y + this->yz * x.z,
      this->xz * x.x + this->yz * x.y + this->zz * x.z };
  }

  double at(const Vec3& x) const { return dot(x, this->times(x) + this->b * 2.0) + this->c; }

  enum class Precision
  {
    rough, ///< strong directions are off by a hundred thousandth of the way
    fine
  };

  /// Where the sum is least; where it hardly tells (in a plane, along a line) the place nearest to
  /// `near`.
  Vec3 least(const Vec3& near, Precision precision) const
  {
    // (A + e I) d = -(A near + b): the share of e keeps directions that no plane decides
    constexpr double kShare = 1e-5;
    const double e = kShare * this->weight();
    const double a11 = this->xx + e;
    const double a22 = this->yy + e;
    const double a33 = this->zz + e;
    const double c11 = a22 * a33 - this->yz * this->yz;
    const double c12 = this->xz * this->yz - this->xy * a33;
    const double c13 = this->xy * this->yz - this->xz * a22;
    const double determinant = a11 * c11 + this->xy * c12 + this->xz * c13;
    if (!(determinant > 0.0))
    {
      return near;
    }
    const double c22 = a11 * a33 - this->xz * this->xz;
    const double c23 = this->xy * this->xz - a11 * this->yz;
    const double c33 = a11 * a22 - this->xy * this->xy;
    const auto solve = [&](const Vec3& r)
    {
      return Vec3{ c11 * r.x + c12 * r.y + c13 * r.z, c12 * r.x + c22 * r.y + c23 * r.z,
        c13 * r.x + c23 * r.y + c33 * r.z } *
        (1.0 / determinant);
    };
    const Vec3 r = (this->times(near) + this->b) * -1.0;
    const Vec3 d = solve(r);
    // a second step takes back what e has changed
    return near + (precision == Precision::rough ? d : d + solve(r - this->times(d)));
  }
};

} // namespace scan
