// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/mesh.h"

#include <span>
#include <vector>

namespace scan
{

/// The indices of the points in the order of a Hilbert curve through their bounding box: what is
/// near on the curve is near in space. Equal points stand together, by index. Depends on the
/// points alone. Clusters far smaller than the box get curves of their own. Linear in practice;
/// needs finite coordinates and 16 bytes of scratch space a point, twice.
std::vector<Index> hilbertOrder(std::span<const Vec3> points, Execution& execution);

} // namespace scan
