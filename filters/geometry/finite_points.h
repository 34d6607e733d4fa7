// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/error.h"
#include "filters/geometry/mesh.h"

#include <algorithm>
#include <cmath>

namespace scan
{

/// Throws Error badInput for coordinates that are not finite.
inline void requireFinitePoints(const TriMesh& mesh)
{
  const auto isFinite = [](const Vec3& p)
  { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); };
  if (!std::ranges::all_of(mesh.points, isFinite))
  {
    throw Error(ErrorCode::badInput, "the surface has points that are not finite; remove them");
  }
}

} // namespace scan
