// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/delaunay_cells.h"

#include <memory>
#include <span>

namespace scan
{

/// Triangulates distinct points that follow a Hilbert curve, on all threads. The set of cells
/// depends on the points alone; their numbers and the order of their vertices do not.
/// @throws Error badInput for points in one plane, limit beyond 2^30 cells; Cancelled.
/// Reports phase "triangulate" up to four fifths. 36 bytes a cell.
/// Amenta, Choi, Rote, "Incremental constructions con BRIO" (2003).
std::unique_ptr<DelaunayCells> insertPoints(std::span<const Vec3> points, Execution& execution);

} // namespace scan
