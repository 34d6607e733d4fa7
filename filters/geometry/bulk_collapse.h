// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/blocks.h"
#include "filters/geometry/wrap_complex.h"

#include <span>
#include <vector>

namespace scan
{

/// What goes from a wrap with some volume blocks.
struct BulkLoss
{
  std::vector<Index> tets;
  std::vector<Facet> bared; ///< triangles that lose their last tetrahedron and stay as sheets
  std::vector<Facet> free;  ///< free triangles that go; the others go with a tetrahedron of `tets`
};

/// Finds everything that collapses once the sinks of `volumes` are gone from a state that follows
/// the flow, and the `doors` (in increasing order) whose sides are both gone: the same as the
/// collapses one after the other, in any order. Each interval is decided once, in parallel: it goes
/// when no critical simplex that is left holds it. Time: a pass over the tetrahedra, and what the
/// volumes hold; memory: two bytes a tetrahedron. Edelsbrunner, "Surface reconstruction by wrapping
/// finite sets in space" (2003), section 6.
BulkLoss findBulkLoss(const WrapComplex& kept, const Blocks& blocks, std::span<const Index> volumes,
  std::span<const Facet> doors, Execution& execution);

} // namespace scan
