// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/length.h"
#include "filters/geometry/mesh.h"

#include <span>

namespace scan
{

/// A length in model units, for a model with these points: percent of their bounding-box diagonal,
/// multiples of their mean spacing. The spacing is measured only when it is asked for.
/// @param millimetresPerUnit 0: unknown, counts as 1
double inModelUnits(const Length& length, std::span<const Vec3> points, double millimetresPerUnit);

/// The same for operations that points without extent leave nothing to do: their relative lengths
/// are 0.
double inModelUnitsOrZero(
  const Length& length, std::span<const Vec3> points, double millimetresPerUnit);

} // namespace scan
