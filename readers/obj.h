// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/mesh.h"

#include <span>
#include <string_view>

namespace scan
{

/// Reads the vertices and faces of a Wavefront OBJ file; everything else is skipped.
///
/// Corners may be a, a/b, a//c or a/b/c, counted from 1, or from the last vertex when negative; a
/// backslash at its end continues a line. Polygons become fans; faces of one or two corners are
/// left out. A file of vertices only is a scan.
///
/// Throws Error parse, with the line, for a malformed line, for corners without a vertex, for a
/// file without any vertex and for coordinates that are not finite or exceed 1e50; Error limit for
/// 2^32 - 1 points. Phase "read".
TriMesh parseObj(std::span<const char> bytes, std::string_view name, Execution& execution);

/// Whether a file that starts with `head` can be an OBJ file: its first line that is neither blank
/// nor a comment is one of the format.
bool looksLikeObj(std::span<const char> head);

} // namespace scan
