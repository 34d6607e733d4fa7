// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/half_edges.h"
#include "filters/geometry/mesh.h"

#include <array>
#include <span>
#include <vector>

namespace scan
{

/// Two half-edges on the boundary that lie on each other and do not have the same points.
using SeamEdge = std::array<Index, 2>;

/// Where a surface is torn: edges of the boundary whose ends are in the same places as those of
/// exactly one other, either way round. Sorted. Time n log n in the edges of the boundary.
std::vector<SeamEdge> findSeams(const TriMesh& mesh, const EdgePairs& pairs);

/// Makes the points of seams one: triangles name the smallest of each place that the edges join.
/// Points that nothing names any more stay.
void closeSeams(TriMesh& mesh, std::span<const SeamEdge> seams);

} // namespace scan
