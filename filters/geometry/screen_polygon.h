// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/incidence.h"
#include "filters/geometry/region_view.h"

#include <algorithm>
#include <array>
#include <span>
#include <vector>

namespace scan
{

/// The inside of a polygon on the screen by the even-odd rule, whatever its shape. Of two polygons
/// on either side of a side exactly one contains a point there. A query looks at the sides at its
/// height only, so that a lasso may have thousands.
class ScreenPolygon
{
public:
  explicit ScreenPolygon(std::span<const ScreenPoint> corners)
  {
    const auto [low, high] = std::ranges::minmax(corners, {}, &ScreenPoint::y);
    this->Low = low.y;
    this->Height = high.y - low.y;
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
      const ScreenPoint& a = corners[i];
      const ScreenPoint& b = corners[i + 1 < corners.size() ? i + 1 : 0];
      this->Sides.push_back(a.y < b.y ? std::array{ a, b } : std::array{ b, a });
    }
    this->AtBand = Incidence(kBands, this->Sides.size(),
      [&](std::size_t side, auto&& visit)
      {
        const auto& [lower, upper] = this->Sides[side];
        for (Index band = this->bandOf(lower.y); band <= this->bandOf(upper.y); ++band)
        {
          visit(band);
        }
      });
  }

  bool contains(const ScreenPoint& p) const
  {
    if (!(p.y >= this->Low && p.y <= this->Low + this->Height))
    {
      return false;
    }
    bool isInside = false;
    for (const Index side : this->AtBand.of(this->bandOf(p.y)))
    {
      const auto& [lower, upper] = this->Sides[side];
      if (lower.y <= p.y && p.y < upper.y &&
        p.x < lower.x + (upper.x - lower.x) * ((p.y - lower.y) / (upper.y - lower.y)))
      {
        isInside = !isInside;
      }
    }
    return isInside;
  }

private:
  static constexpr Index kBands = 64;

  Index bandOf(double y) const
  {
    const double share = this->Height > 0.0 ? (y - this->Low) / this->Height : 0.0;
    return std::min(static_cast<Index>(share * kBands), kBands - 1);
  }

  std::vector<std::array<ScreenPoint, 2>> Sides; ///< the lower end first
  Incidence AtBand;                              ///< sides per band of the height
  double Low = 0.0;
  double Height = 0.0;
};

} // namespace scan
