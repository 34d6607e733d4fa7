// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/mesh.h"

#include <cmath>

namespace truth
{

/// Signed distance to the outline of two discs and their common tangents, exact to rounding.
/// @param along from the centre of the first disc towards that of the second
/// @param across from the line through the centres, not negative
/// @param length between the centres
inline double outlineDistance(
  double along, double across, double length, double firstRadius, double secondRadius)
{
  const double slope = (firstRadius - secondRadius) / length;
  const double rise = std::sqrt(1.0 - slope * slope);
  const double place = rise * along - slope * across;
  if (place < 0.0)
  {
    return std::sqrt(along * along + across * across) - firstRadius;
  }
  if (place > rise * length)
  {
    return std::sqrt((along - length) * (along - length) + across * across) - secondRadius;
  }
  return slope * along + rise * across - firstRadius;
}

inline constexpr double kDifferenceStep = 1e-4;

/// By how much a field differs between two places `kDifferenceStep` before and behind, per axis.
template <class Field>
scan::Vec3 differences(const scan::Vec3& p, Field&& field)
{
  const auto along = [&](const scan::Vec3& axis)
  { return field(p + axis * kDifferenceStep) - field(p - axis * kDifferenceStep); };
  return { along({ 1, 0, 0 }), along({ 0, 1, 0 }), along({ 0, 0, 1 }) };
}

} // namespace truth
