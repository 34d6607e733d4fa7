// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/model_edit.h"

#include <span>

namespace scan
{

struct FlattenReport : EditReport
{
  Index parts = 0; ///< thin parts that became sheets
};

/// Replaces thin parts by sheets, such as the sliver that stays on every quad of a regular grid.
///
/// A part is a set of kept tetrahedra that hang together by triangles. Its boundary turns back on
/// itself at the edges with an acute interior angle; cut there, a thin part falls into two disks
/// with the same rim, on which all its vertices lie: two triangulations of one polygon, of which
/// one is enough, and no point is lost. The one stays whose circumradii, sorted from large to
/// small, are lexicographically smaller, as in the Delaunay triangulation of a plane; of two with
/// the same radii the one with the triangle that comes first in the complex. Where the part was
/// glued to sheets along its rim, an edge loses one of its triangles on this part, so that it is a
/// manifold edge afterwards.
///
/// Only parts with a triangle in the region. A solid model that has thin parts has sheets
/// afterwards, and is no solid model any more. Linear time. Reports phase "flatten".
FlattenReport flatten(WrapModel& model, std::span<const Facet> region, Execution& execution);

} // namespace scan
