// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/point_links.h"

#include <cstdint>
#include <span>
#include <vector>

namespace scan
{

struct FeatureLines
{
  /// Per point the other ends of its feature edges, rising.
  PointLists along;
  std::size_t edges = 0;
  std::size_t corners = 0; ///< points where a line ends or lines meet
};

/// The edges where triangles meet at a larger angle than a limit. Fewer than a handful that hang
/// together count for noise.
/// @param normals per triangle, of the same side
/// @param angle radians
FeatureLines findFeatureLines(
  const TriMesh& mesh, std::span<const Vec3> normals, double angle, Execution& execution);

} // namespace scan
