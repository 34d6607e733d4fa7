// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/region_view.h"

#include "filters/base/error.h"
#include "filters/geometry/view_sides.h"

#include <algorithm>
#include <cmath>

namespace scan
{
namespace
{

double largest(const Vec3& v)
{
  return std::max({ std::abs(v.x), std::abs(v.y), std::abs(v.z) });
}

/// Of length 1, also where squares would overflow; zero stays zero.
Vec3 normalized(const Vec3& v)
{
  const double scale = largest(v);
  const Vec3 u = scale > 0.0 ? Vec3{ v.x / scale, v.y / scale, v.z / scale } : v;
  return scale > 0.0 ? u * (1.0 / std::sqrt(dot(u, u))) : u;
}

} // namespace

std::optional<std::size_t> viewNumbers(std::string_view name)
{
  if (std::ranges::find(kViewSides, name, &ViewSide::name) != kViewSides.end())
  {
    return 0;
  }
  return name == "from" ? std::optional<std::size_t>(9)
    : name == "along"   ? std::optional<std::size_t>(6)
                        : std::nullopt;
}

Screen::Screen(const RegionView& view)
{
  if (view.name == "from")
  {
    this->Eye = vectorAt(view.numbers, 0);
    const Vec3 towards = this->Eye - vectorAt(view.numbers, 3);
    this->Distance = std::hypot(towards.x, towards.y, towards.z);
    this->aim(towards, vectorAt(view.numbers, 6));
  }
  else if (view.name == "along")
  {
    this->aim(vectorAt(view.numbers, 0) * -1.0, vectorAt(view.numbers, 3));
  }
  else
  {
    const ViewSide& side = *std::ranges::find(kViewSides, view.name, &ViewSide::name);
    this->aim(side.towards, side.up);
  }
}

void Screen::aim(const Vec3& towards, const Vec3& up)
{
  constexpr double kLeastSine = 1e-9;
  this->Back = normalized(towards);
  const Vec3 right = cross(normalized(up), this->Back);
  if (!(largest(right) > kLeastSine) || !std::isfinite(this->Distance))
  {
    throw Error(ErrorCode::badParameter,
      "a view needs a direction to look in and one that points up, and the two must differ");
  }
  this->Right = normalized(right);
  this->Up = cross(this->Back, this->Right);
}

std::optional<ScreenPoint> Screen::project(const Vec3& point) const
{
  const Vec3 p = point - this->Eye;
  const ScreenPoint at{ dot(p, this->Right), dot(p, this->Up) };
  if (this->Distance == 0.0)
  {
    return at;
  }
  const double depth = -dot(p, this->Back);
  const double scale = this->Distance / depth;
  return depth > 0.0 ? std::optional(ScreenPoint{ at.x * scale, at.y * scale }) : std::nullopt;
}

double Screen::nearer(const Vec3& point, const Vec3& than) const
{
  return dot(point - than, this->Back);
}

} // namespace scan
