// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/mesh.h"

#include <span>

namespace scan
{

/// The absolute mean curvature of the surface at a point, in 1 / model unit: 1 / r on a sphere of
/// radius r, 1 / (2 r) on a cylinder, 0 on a plane.
///
/// Fits a paraboloid to the point and the first 64 points around it, over the plane that they
/// suggest. The error is proportional to the square of their distance; noise averages out. Not a
/// number where there are fewer than six around or all are at one place. Cazals, Pouget,
/// "Estimating differential quantities using polynomial fitting of osculating jets" (2005), of
/// degree two.
double meanCurvature(const Vec3& point, std::span<const Vec3> around);

} // namespace scan
