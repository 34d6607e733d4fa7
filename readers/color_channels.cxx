// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/color_channels.h"

#include "readers/point_attributes.h"

#include <algorithm>
#include <limits>

namespace scan
{
namespace
{

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr std::array<float, 3> kMissing = { kNan, kNan, kNan };

} // namespace

void ColorChannels::add(double red, double green, double blue)
{
  if (isChannel(red) && isChannel(green) && isChannel(blue))
  {
    this->Largest = std::max({ this->Largest, red, green, blue });
    this->Values.push_back(
      { static_cast<float>(red), static_cast<float>(green), static_cast<float>(blue) });
  }
  else
  {
    this->Values.push_back(kMissing);
  }
}

void ColorChannels::skipTo(std::size_t points)
{
  this->Values.resize(std::max(points, this->Values.size()), kMissing);
}

std::vector<Color> ColorChannels::take(std::size_t points)
{
  std::vector<Color> colors;
  if (this->Largest >= 0.0)
  {
    constexpr double kRounded = 1.01;
    const double scale = this->Largest > kRounded ? 1.0 : 255.0;
    const auto channel = [&](float value) { return toChannel(std::min(value * scale, 255.0)); };
    colors.reserve(points);
    for (const auto& [red, green, blue] : this->Values)
    {
      const bool isMissing = red != red;
      colors.push_back(isMissing ? kNoColor : Color{ channel(red), channel(green), channel(blue) });
    }
    colors.resize(points, kNoColor);
  }
  *this = {};
  return colors;
}

} // namespace scan
