// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/mend_surface.h"

#include <cstddef>

namespace scan
{

// The gentle means of repairIntersections(): points move, triangles stay.

/// Draws points back from others in the same place. @return how many moved
std::size_t pullApart(MendSurface& surface, double maxDeviation, Execution& execution);

/// Smooths the surface around intersections. @return how many points moved
std::size_t relaxLocally(MendSurface& surface, double maxDeviation, Execution& execution);

} // namespace scan
