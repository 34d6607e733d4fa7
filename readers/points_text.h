// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/mesh.h"

#include <span>
#include <string_view>

namespace scan
{

/// Reads a vertex list (.xyz .txt .asc .pts .csv .pwn): one point a line, x y z in the first three
/// columns, further columns ignored.
///
/// Columns are separated by blanks, tabs, one comma or one semicolon; lines end with LF, CRLF or
/// CR; a UTF-8 byte order mark, blank lines and comments (# // ! %) are skipped. Ahead of the first
/// point there may be lines that start with a word and a line with one number, the count, which
/// real files get wrong and nothing relies on. Also reads "p x y z" lists, whose other lines start
/// with another letter.
///
/// Throws Error parse for text without points, for a line that is no point, for decimal commas,
/// for UTF-16, and for coordinates that are not finite or exceed 1e50.
/// Phase "read"; parallel, the same points for any number of threads.
TriMesh parsePointsText(std::span<const char> bytes, std::string_view name, Execution& execution);

/// Whether a file that starts with `head` can be a vertex list.
bool looksLikePointsText(std::span<const char> head);

} // namespace scan
