// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/model.h"

#include <span>
#include <string_view>

namespace scan
{

/// Reads a Polygon File Format file, ascii or binary of either byte order.
///
/// The element "vertex" needs the properties x, y and z of any type. Lists named vertex_indices or
/// vertex_index give polygons in "face", which become triangles, and strips in "tristrips", where
/// -1 starts a new strip. Faces of fewer than three corners are left out. Vertices have colours
/// with red, green and blue, or diffuse_red and so on: integers of 0 to 255, or reals of 0 to 1 (to
/// 255 when any exceeds 1); one out of range is white. They have normals with nx, ny and nz, which
/// become of length 1 or 0. Every other element and property is skipped, so the Stanford range
/// scans load.
///
/// Throws Error parse, with line or byte, for a malformed or truncated file, for a second element
/// "vertex", for indices without a vertex and for coordinates that are not finite or exceed 1e50;
/// Error limit for 2^32 - 1 points. Phase "read".
Model parsePly(std::span<const char> bytes, std::string_view name, Execution& execution);

/// parsePly, and triangles across the element "range_grid" of scans of Cyberware's and Stanford's
/// scanners: two for each cell of the grid with four points, however long its edges are. They face
/// the scanner when the columns run to its right and the rows upwards, as in the Stanford scans.
///
/// Throws as parsePly, and Error parse when the header's obj_info num_cols and num_rows do not give
/// the size of the grid. A file without a range_grid is read as by parsePly.
Model parsePlyRangeGrid(std::span<const char> bytes, std::string_view name, Execution& execution);

/// Whether the file is of this format.
bool looksLikePly(std::span<const char> head);

} // namespace scan
