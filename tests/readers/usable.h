// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/model.h"

#include <algorithm>
#include <cmath>

namespace scan::test
{

/// Whether all that a parser guarantees of its model is true.
inline bool isUsable(const Model& model)
{
  const auto isFinite = [](const Vec3& p)
  { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); };
  const auto hasCorners = [&](const Triangle& t) {
    return std::max({ t[0], t[1], t[2] }) < model.points.size();
  };
  return std::all_of(model.points.begin(), model.points.end(), isFinite) &&
    std::all_of(model.normals.begin(), model.normals.end(), isFinite) &&
    std::all_of(model.triangles.begin(), model.triangles.end(), hasCorners) &&
    (model.colors.empty() || model.colors.size() == model.points.size()) &&
    (model.normals.empty() || model.normals.size() == model.points.size()) &&
    std::isfinite(model.millimetresPerUnit) && model.millimetresPerUnit >= 0.0;
}

} // namespace scan::test
