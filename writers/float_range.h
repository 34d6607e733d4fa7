// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/error.h"
#include "filters/geometry/mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace scan
{

/// Throws Error limit when a coordinate exceeds what a float32 of the format holds.
inline void requireFloatRange(
  const TriMesh& mesh, const std::string& file, const std::string& format)
{
  const auto fits = [](double value)
  { return std::abs(value) <= std::numeric_limits<float>::max(); };
  if (!std::all_of(mesh.points.begin(), mesh.points.end(),
        [&](const Vec3& p) { return fits(p.x) && fits(p.y) && fits(p.z); }))
  {
    throw Error(ErrorCode::limit,
      file + ": a coordinate exceeds 3.4e38, the limit of " + format + "; write PLY or OBJ");
  }
}

} // namespace scan
