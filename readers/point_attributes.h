// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/model.h"

#include <cmath>
#include <cstddef>

namespace scan
{

/// What points without a colour get in a file where others have one.
inline constexpr Color kNoColor = { 255, 255, 255 };

/// The normal at length 1; 0 when its length is 0, not finite, or too small to be divided by.
inline Vec3 unitOrZero(const Vec3& normal)
{
  const double length = std::hypot(normal.x, normal.y, normal.z);
  return std::isnormal(length) ? Vec3{ normal.x / length, normal.y / length, normal.z / length }
                               : Vec3{};
}

/// Whether the value is a channel of 0 to 255; false for NaN.
inline bool isChannel(double value)
{
  return value >= 0.0 && value <= 255.0;
}

/// The nearest channel of a value that is one.
inline std::uint8_t toChannel(double value)
{
  return static_cast<std::uint8_t>(std::lround(value));
}

} // namespace scan
