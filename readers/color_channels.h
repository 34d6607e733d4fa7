// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/model.h"

#include <array>
#include <cstddef>
#include <vector>

namespace scan
{

/// Gathers colours whose range is 0 to 1, or 0 to 255 when any channel exceeds 1 by more than
/// rounding: which one is known only at the end of the file.
class ColorChannels
{
public:
  void reserve(std::size_t points) { this->Values.reserve(points); }

  /// The colour of the next point, which has none when a channel is not of 0 to 255.
  void add(double red, double green, double blue);

  /// Points without a colour, until there are so many points.
  void skipTo(std::size_t points);

  /// A colour per point, white for points without one; empty when no point has one. Clears the
  /// channels.
  std::vector<Color> take(std::size_t points);

private:
  std::vector<std::array<float, 3>> Values; // NaN for points without a colour
  double Largest = -1.0;                    // of all channels; below 0 while there is no colour
};

} // namespace scan
