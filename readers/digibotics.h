// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/model.h"

#include <span>
#include <string_view>

namespace scan
{

/// Reads the contours of a Digibotics digitizer from text (.dbt .dig): points slice by slice, in
/// the order of the file.
///
/// UNVERIFIED: no description of the format and no sample file was found. What is read is what such
/// text plausibly holds: lines of x y z, separated by blanks, commas or semicolons, where a first
/// column that counts the points is skipped; between the slices blank lines, lines that start with
/// a word and lines of one number; comments behind # ! // or a semicolon at the start of a line.
/// Model::millimetresPerUnit follows from a word for inch, mm or cm ahead of the first point, best
/// on a line with "units"; without one it is 0.
///
/// Throws Error parse for binary files, whose form is not documented, for a line of numbers that is
/// no point, for decimal commas, for text with fewer points than lines of words, and for
/// coordinates that are not finite or exceed 1e50; Error limit for 2^32 - 1 points. Phase "read".
Model parseDigibotics(std::span<const char> bytes, std::string_view name, Execution& execution);

/// Whether a file that starts with `head` holds lines of x y z, and a line that names a slice, a
/// unit or the maker. Plain lists of points are left to the other formats.
bool looksLikeDigibotics(std::span<const char> head);

} // namespace scan
