// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/model.h"

#include <cstddef>
#include <vector>

namespace scan
{

/// Per point of `pointCount`: whether a triangle or a curve uses it.
std::vector<bool> usedPoints(
  const std::vector<Triangle>& triangles, const Polylines& curves, std::size_t pointCount);

/// The points that say where a model is and how large: those of triangles with area and of curves,
/// all of a scan. In the order of the model.
std::vector<Vec3> shapePoints(const Model& model);

} // namespace scan
