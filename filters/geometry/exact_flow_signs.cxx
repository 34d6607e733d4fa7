// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/exact_flow_signs.h"

#include <CGAL/Number_types/internal/Exact_type_selector.h>

#include <algorithm>
#include <array>
#include <tuple>

namespace scan
{
namespace
{

using Exact = CGAL::internal::Exact_ring_selector<double>::Type;

struct ExactVec3
{
  Exact x, y, z;
};

ExactVec3 difference(const Vec3& a, const Vec3& b)
{
  return { Exact(a.x) - Exact(b.x), Exact(a.y) - Exact(b.y), Exact(a.z) - Exact(b.z) };
}

ExactVec3 cross(const ExactVec3& a, const ExactVec3& b)
{
  return { a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x };
}

Exact dot(const ExactVec3& a, const ExactVec3& b)
{
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

int signOf(const Exact& value)
{
  return static_cast<int>(CGAL::sign(value));
}

bool lexicographicallyLess(const Vec3& a, const Vec3& b)
{
  return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
}

/// s lies on the smallest sphere through a, b, c: the sign of
/// eps(s) - sum over p of eps(p) beta_p, with beta the barycentric coordinates of the projection
/// of s onto their plane; the largest eps with a coefficient that is not zero decides.
bool insideAfterPerturbation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& s)
{
  const ExactVec3 normal = cross(difference(b, a), difference(c, a));
  const auto beta = [&](const Vec3& p, const Vec3& q)
  { return signOf(dot(cross(difference(p, s), difference(q, s)), normal)); };
  std::array<const Vec3*, 4> largestFirst{ &a, &b, &c, &s };
  std::sort(largestFirst.begin(), largestFirst.end(),
    [](const Vec3* p, const Vec3* q) { return lexicographicallyLess(*q, *p); });
  for (const Vec3* p : largestFirst)
  {
    if (p == &s)
    {
      return false;
    }
    const int sign = p == &a ? beta(b, c) : p == &b ? beta(c, a) : beta(a, b);
    if (sign != 0)
    {
      return sign > 0;
    }
  }
  return false;
}

} // namespace

bool insideSmallestSphere(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& s)
{
  // with a as origin the centre is (|c|^2 n x b + |b|^2 c x n) / 2|n|^2, n = b x c
  const ExactVec3 eb = difference(b, a);
  const ExactVec3 ec = difference(c, a);
  const ExactVec3 es = difference(s, a);
  const ExactVec3 n = cross(eb, ec);
  const Exact power = dot(es, es) * dot(n, n) - dot(ec, ec) * dot(es, cross(n, eb)) -
    dot(eb, eb) * dot(es, cross(ec, n));
  const int sign = signOf(power);
  return sign != 0 ? sign < 0 : insideAfterPerturbation(a, b, c, s);
}

bool insideDiametralSphere(const Vec3& a, const Vec3& b, const Vec3& s)
{
  const int sign = signOf(dot(difference(a, s), difference(b, s)));
  return sign != 0 ? sign < 0 : lexicographicallyLess(s, a) || lexicographicallyLess(s, b);
}

} // namespace scan
