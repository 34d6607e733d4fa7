// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/mesh.h"

#include <vector>

namespace scan
{

/// Per point the unit normal of the surface, to the side that its triangles face: the sum of
/// theirs, each by its angle at the point (Thürmer, Wüthrich 1998). (0, 0, 0) where there is none.
/// Linear time. Triangles name points that are there.
std::vector<Vec3> vertexNormals(const TriMesh& mesh);

} // namespace scan
