// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

/// The transfer function of sRGB (IEC 61966-2-1), for formats that hold linear light.
namespace scan
{

/// The light of a channel, 0 to 1.
inline double linearOf(std::uint8_t channel)
{
  const double value = channel / 255.0;
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

/// The channel of a light; what is not of 0 to 1 counts as the nearest that is, NaN as 0.
inline std::uint8_t channelOf(double light)
{
  const double value = light > 0.0 ? std::min(light, 1.0) : 0.0;
  const double channel =
    value <= 0.0031308 ? 12.92 * value : 1.055 * std::pow(value, 1.0 / 2.4) - 0.055;
  return static_cast<std::uint8_t>(std::lround(channel * 255.0));
}

} // namespace scan
