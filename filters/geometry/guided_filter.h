// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/point_links.h"

#include <cstdint>
#include <limits>
#include <span>
#include <string_view>
#include <vector>

namespace scan
{

struct GuidedFilter
{
  int rounds = 20;
  double angle = 0.7; ///< radians: normals farther apart are not mixed
  double limit = std::numeric_limits<double>::infinity(); ///< model units: no point moves farther
};

struct GuidedResult
{
  std::vector<Vec3> points;
  std::vector<Vec3> normals; ///< per triangle, filtered; (0, 0, 0) where it has no area
};

/// Takes noise out of faces and edges of a surface with sharp edges. Normals of triangles are
/// averaged over neighbours on the same side of an edge; what side that is tells a guide, the mean
/// of that patch around the triangle in which normals agree best (Zhang et al. 2015). Then points
/// move so that triangles follow their normals (Sun et al. 2007), and all again.
/// @param isMovable per point 0 for those that stay
GuidedResult guidedFilter(const TriMesh& mesh, const PointLists& trianglesOfPoints,
  std::span<const std::uint8_t> isMovable, const GuidedFilter& options, std::string_view phase,
  Execution& execution);

} // namespace scan
