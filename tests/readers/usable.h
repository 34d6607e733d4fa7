// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/model.h"

#include <algorithm>
#include <cmath>

namespace scan::test
{

/// Whether each curve has two corners or more, and each corner a point.
inline bool hasCurves(const Model& model)
{
  std::size_t begin = 0;
  for (const std::size_t end : model.curves.ends)
  {
    if (end < begin + 2 || end > model.curves.corners.size())
    {
      return false;
    }
    begin = end;
  }
  return begin == model.curves.corners.size() &&
    std::all_of(model.curves.corners.begin(), model.curves.corners.end(),
      [&](Index corner) { return corner < model.points.size(); });
}

/// Whether all that a parser guarantees of its model is true.
inline bool isUsable(const Model& model)
{
  const auto isFinite = [](const Vec3& p)
  { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); };
  const auto isNormal = [](const Vec3& n)
  { return n == Vec3{} || std::abs(dot(n, n) - 1.0) < 1e-12; };
  const auto hasCorners = [&](const Triangle& t) {
    return std::max({ t[0], t[1], t[2] }) < model.points.size();
  };
  return std::all_of(model.points.begin(), model.points.end(), isFinite) &&
    std::all_of(model.normals.begin(), model.normals.end(), isNormal) &&
    std::all_of(model.triangles.begin(), model.triangles.end(), hasCorners) && hasCurves(model) &&
    (model.colors.empty() || model.colors.size() == model.points.size()) &&
    (model.normals.empty() || model.normals.size() == model.points.size()) &&
    std::isfinite(model.millimetresPerUnit) && model.millimetresPerUnit >= 0.0;
}

} // namespace scan::test
