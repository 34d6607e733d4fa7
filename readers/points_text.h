// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/model.h"

#include <span>
#include <string_view>

namespace scan
{

/// Reads a vertex list (.xyz .txt .asc .pts .csv .pwn): one point a line, x y z in the first three
/// columns, perhaps a colour r g b of 0 to 255 and a normal nx ny nz behind them.
///
/// A line ahead of the points may name as many columns as they have: x y z, which need not be the
/// first, and somewhere behind r g b (red green blue; rf gf bf) and nx ny nz. Without it, what
/// further columns hold is decided by the first 1000 points (of 256 KB), by those of them that have
/// the most columns, all of them numbers:
/// - 6 columns are x y z and a normal when its length is 1 +- 0.02 or 0 in all of them, x y z r g b
///   when the three are integers of 0 to 255 in all of them; only zeros could be both;
/// - 7 columns are x y z, an intensity and r g b when the last three are such integers; or x y z
///   r g b and an opacity when the last one is 255 throughout and the two ahead of it vary;
/// - 9 columns are x y z r g b nx ny nz when both hold.
/// Everything else, the intensity too, is ignored. Lines without colour or normal, or with one out
/// of range, are white or get 0 0 0 beside others. Normals become of length 1.
///
/// Columns are separated by blanks, tabs, one comma or one semicolon; lines end with LF, CRLF or
/// CR; a UTF-8 byte order mark, blank lines and comments (# // ! %) are skipped. Ahead of the first
/// point there may be lines that start with a word and a line with one number, the count, which
/// real files get wrong and nothing relies on. Also reads "p x y z" lists, whose other lines start
/// with another letter. Points that are not a number are left out, with a note.
///
/// Throws Error parse for text without points, for a line that is no point, for decimal commas,
/// for UTF-16, and for coordinates that are infinite or exceed 1e50.
/// Phase "read"; parallel, the same points for any number of threads.
Model parsePointsText(std::span<const char> bytes, std::string_view name, Execution& execution);

/// Whether a file that starts with `head` can be a vertex list.
bool looksLikePointsText(std::span<const char> head);

} // namespace scan
