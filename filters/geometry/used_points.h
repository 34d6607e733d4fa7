// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/mesh.h"

#include <vector>

namespace scan
{

/// Keeps the points of triangles only, in their order. Returns per point what its number was.
std::vector<Index> dropUnusedPoints(TriMesh& mesh);

} // namespace scan
