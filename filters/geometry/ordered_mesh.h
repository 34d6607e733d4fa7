// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/mesh.h"

#include <vector>

namespace scan
{

/// A mesh in an order that keeps near things near in memory, and where its parts come from.
struct OrderedMesh
{
  TriMesh mesh;
  std::vector<Index> pointNames;    ///< in the input
  std::vector<Index> numbers;       ///< per input point its number here
  std::vector<Index> triangleNames; ///< in the input
};

/// Whether the points of many triangles are so far apart in memory that caches are of no use.
bool isScattered(const TriMesh& mesh);

/// Points along a Hilbert curve, triangles by their first points; all as it is where the mesh is
/// not scattered.
OrderedMesh orderedMesh(const TriMesh& mesh, Execution& execution);

} // namespace scan
