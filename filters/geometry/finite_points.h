// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/error.h"
#include "filters/geometry/mesh.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <string>

namespace scan
{

inline bool isFinite(const Vec3& p)
{
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

/// Throws Error badInput for coordinates that are not finite.
inline void requireFinitePoints(std::span<const Vec3> points)
{
  const auto finite = static_cast<std::size_t>(std::ranges::count_if(points, isFinite));
  if (finite < points.size())
  {
    throw Error(ErrorCode::badInput,
      std::to_string(points.size() - finite) + " of " + std::to_string(points.size()) +
        " points have coordinates that are not finite; remove them");
  }
}

} // namespace scan
