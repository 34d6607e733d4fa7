// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/half_marks.h"

#include <algorithm>
#include <cmath>

namespace scan
{
namespace
{

double largestCoordinate(const Vec3& v)
{
  return std::max({ std::abs(v.x), std::abs(v.y), std::abs(v.z) });
}

/// But for the rounding of a transformation.
bool isInTheMiddle(const Vec3& middle, const Vec3& a, const Vec3& b)
{
  constexpr double kRounding = 1e-13;
  const double error = largestCoordinate(middle - (a + b) * 0.5);
  return error <= kRounding * std::max(largestCoordinate(a), largestCoordinate(b));
}

bool isHalf(std::uint8_t mark)
{
  return mark >= 1 && mark <= 6;
}

/// Whether the first half has its second.
bool hasTwin(const TriMesh& mesh, std::span<const std::uint8_t> marks, std::span<const Index> mate,
  Index triangle)
{
  const Index seam = seamOf(triangle, marks[triangle]); // m c
  const Index other = mate[seam];                       // c m
  if (other == kNone || !isHalf(marks[other / 3]) || !isSecondHalf(marks[other / 3]) ||
    seamOf(other / 3, marks[other / 3]) != other || originOf(mesh, other) == originOf(mesh, seam))
  {
    return false;
  }
  const Index a = originOf(mesh, previousHalf(seam));
  const Index b = originOf(mesh, previousHalf(other));
  return a != b && isInTheMiddle(mesh.points[originOf(mesh, seam)], mesh.points[a], mesh.points[b]);
}

} // namespace

std::vector<std::uint8_t> trustedHalves(
  const TriMesh& mesh, std::span<const std::uint8_t> marks, std::span<const Index> mate)
{
  std::vector<std::uint8_t> trusted;
  for (Index t = 0; t < marks.size(); ++t)
  {
    if (isHalf(marks[t]) && !isSecondHalf(marks[t]) && hasTwin(mesh, marks, mate, t))
    {
      trusted.resize(marks.size(), 0);
      const Index twin = mate[seamOf(t, marks[t])] / 3;
      trusted[t] = marks[t];
      trusted[twin] = marks[twin];
    }
  }
  return trusted;
}

} // namespace scan
