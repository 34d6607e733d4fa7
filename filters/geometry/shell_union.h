// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/mend_surface.h"
#include "filters/geometry/patch_refill.h"

#include <cstddef>

namespace scan
{

/// What unions made of closed pieces.
struct ShellUnions
{
  std::size_t unions = 0; ///< of two pieces each
  Exchange exchange;
};

/// Makes one of closed pieces that reach into each other: the border of all that is in one of them.
/// Only pieces that face outwards, do not intersect themselves, and of which no corner is exactly
/// in the plane of a triangle that it meets. Triangles that the other piece does not cut stay as
/// they are. By exact corefinement (CGAL); places of the new points are rounded, so that triangles
/// there may be flat or intersect by a rounding.
ShellUnions uniteShells(MendSurface& surface, Execution& execution);

} // namespace scan
