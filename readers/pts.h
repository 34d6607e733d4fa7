// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/model.h"

#include <span>
#include <string_view>

namespace scan
{

/// Reads a PTS file as Leica's Cyclone writes it: a line with the number of points, then a line for
/// each: x y z, an intensity and perhaps a colour r g b of 0 to 255.
///
/// Several scans may follow each other, each with its count; all their points become one model, in
/// the order of the file. Also reads x y z and x y z r g b, and skips what follows a colour. All
/// lines of a scan have the same columns. Points of scans without colours are white beside others.
/// Real files get the counts wrong, so nothing relies on them; a note says when points are missing.
/// Intensities are skipped. No unit.
///
/// Throws Error parse, with the line, for a line that is no point, for a file that starts without
/// a count, for a file without points, for UTF-16, for coordinates that are not finite or exceed
/// 1e50; Error limit for 2^32 - 1 points.
/// Phase "read"; parallel, the same points for any number of threads.
Model parsePts(std::span<const char> bytes, std::string_view name, Execution& execution);

/// Whether a file that starts with `head` is a PTS file: a line with a count, then lines of 3, 4, 6
/// or 7 numbers, whose colours are integers and not all as long as normals. (Others are vertex
/// lists, see points_text.h.)
bool looksLikePts(std::span<const char> head);

} // namespace scan
