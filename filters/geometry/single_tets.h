// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/model_edit.h"

#include <span>

namespace scan
{

/// Fine-tune push: removes the kept tetrahedron behind each marked boundary triangle with its free
/// facets, and each marked sheet triangle alone. What the marks mean is found before anything is
/// removed, so their order does not matter; triangles that are not on the surface are left out.
/// Bares no sheets and leaves no lines but those of the start. The cost is a copy of the state.
EditReport pushTets(WrapModel& model, std::span<const Facet> triangles, Execution& execution);

/// Fine-tune fill, the inverse: adds the gone tetrahedron in front of each marked boundary
/// triangle, or on that side of a marked sheet triangle that the facet is a facet of. Where there
/// is none, beyond the convex hull, the mark is left out, as are triangles that are not on the
/// surface. Filling at a facet that pushTets() bared gives the state before it.
EditReport fillTets(WrapModel& model, std::span<const Facet> triangles, Execution& execution);

} // namespace scan
