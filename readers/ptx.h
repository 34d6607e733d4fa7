// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/model.h"

#include <span>
#include <string_view>

namespace scan
{

/// Reads a PTX file as Leica's Cyclone writes it: gridded scans and where the scanner stood.
///
/// Each scan starts with the number of columns and of rows, a line each; the scanner's place and
/// its three axes, a line of three numbers each; a 4x4 matrix, a line for each row. Then follows a
/// line for each cell: x y z, an intensity and perhaps a colour r g b of 0 to 255. The row vector
/// (x y z 1) times the matrix gives the point, in double precision; the place and the axes say the
/// same once more and are skipped. Cells at 0 0 0 are voids and left out. Several scans follow each
/// other; all their points become one model, in the order of the file. Points of scans without
/// colours are white beside others. The unit is the metre. Intensities are skipped.
///
/// Throws Error parse, with the line, for a malformed line, for scans of more or fewer lines than
/// cells, for a matrix whose last column is not 0 0 0 1, for a file without points, for UTF-16, for
/// coordinates that are not finite or exceed 1e50; Error limit for 2^32 - 1 points.
/// Phase "read"; parallel, the same points for any number of threads.
Model parsePtx(std::span<const char> bytes, std::string_view name, Execution& execution);

/// Whether a file that starts with `head` is a PTX file: two counts, then four lines of three
/// numbers and four of four.
bool looksLikePtx(std::span<const char> head);

} // namespace scan
