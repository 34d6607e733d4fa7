// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/mesh.h"

#include <array>
#include <vector>

namespace scan
{

/// Where the data of a new point come from: the weighted mean of those of up to three input points.
/// The weights sum to 1; unused places have weight 0 and any input point.
struct PointBlend
{
  std::array<Index, 3> from{};
  std::array<double, 3> weights{ 1.0, 0.0, 0.0 };
};

/// What an operation made of a surface, and what became of its parts.
struct SurfaceEdit
{
  TriMesh mesh;
  /// Per point: the input point that it is, perhaps in another place; kNone for a new one.
  std::vector<Index> pointOrigin;
  /// Of the new points, in their order.
  std::vector<PointBlend> blends;
  /// Per triangle: the input triangle that it is, or is a part or a copy of; kNone for a new one.
  std::vector<Index> triangleOrigin;
};

/// An edit that changes nothing yet: every part is itself.
SurfaceEdit unchanged(TriMesh mesh);

} // namespace scan
