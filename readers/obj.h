// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/model.h"

#include <span>
#include <string_view>

namespace scan
{

/// Reads the vertices, faces and lines of a Wavefront OBJ file, the vertices' colours and normals
/// where it has them; everything else is skipped.
///
/// Corners may be a, a/b, a//c or a/b/c, counted from 1, or from the last vertex when negative; a
/// backslash at its end continues a line. Polygons become triangles; faces of one or two corners
/// are left out. A file of vertices only is a scan.
///
/// A vertex x y z r g b has a colour: of 0 to 1, or of 0 to 255 when any number in the file's
/// colours exceeds 1. Vertices without one, and those out of range, are white beside others.
/// Normals become of length 1 or 0. They are kept when each corner has the normal of the same
/// index as its vertex, or when a file without faces has as many normals as vertices; others are
/// normals of corners, not of points.
///
/// Throws Error parse, with the line, for a malformed line, for corners without a vertex, for a
/// file without any vertex and for coordinates that are not finite or exceed 1e50; Error limit for
/// 2^32 - 1 points. Phase "read".
Model parseObj(std::span<const char> bytes, std::string_view name, Execution& execution);

/// Whether a file that starts with `head` can be an OBJ file: its first line that is neither blank
/// nor a comment is one of the format.
bool looksLikeObj(std::span<const char> head);

} // namespace scan
