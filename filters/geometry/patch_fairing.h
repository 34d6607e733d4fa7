// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/mesh.h"

#include <cstdint>
#include <span>

namespace scan
{

/// Moves the free points to where the surface continues most smoothly: they solve the Laplace
/// equation to a power, with cotangent weights of the shape at hand (Botsch, Kobbelt 2004). Power 2
/// continues the tangent planes of the surface around, power 3 its curvature, too; the mesh must
/// then hold the triangles at the fixed points that share an edge with a free one, and with power 3
/// those at the neighbours of these. Points of a mesh without a solution stay.
/// @param isFree per point 0 or 1
/// @param power 1 to 3
void fairPoints(
  TriMesh& mesh, std::span<const std::uint8_t> isFree, int power, Execution& execution);

} // namespace scan
