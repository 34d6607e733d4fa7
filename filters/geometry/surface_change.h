// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/wrap_complex.h"

#include <vector>

namespace scan
{

/// What an edit did to the surface: enough for a view to update what it shows. Canonical names, in
/// increasing order.
struct SurfaceChange
{
  std::vector<Facet> gone;
  std::vector<Facet> added;
};

/// Whether a triangle bounds a solid or is a sheet.
inline bool isOnSurface(const WrapComplex& complex, Facet triangle)
{
  return complex.keptSides(triangle) == 1 || complex.isSheet(triangle);
}

/// Compares two states of a complex. Time: a fast pass over their bytes, and what changed.
SurfaceChange compareSurfaces(
  const WrapComplex& before, const WrapComplex& after, Execution& execution);

} // namespace scan
