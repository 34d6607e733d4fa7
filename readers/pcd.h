// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/model.h"

#include <span>
#include <string_view>

namespace scan
{

/// Reads a Point Cloud Data file of the Point Cloud Library, version 0.5 to 0.7, with the data
/// ascii, binary (little-endian) or binary_compressed (LZF).
///
/// The fields may stand in any order and have any type; x, y and z are needed. rgb or rgba gives
/// colours: eight bits each in an integer or in the bits of a float. normal_x, normal_y and
/// normal_z give normals. Every other field is skipped. Points with a coordinate that is not a
/// number, which organised clouds have for what the sensor did not see, are left out. The viewpoint
/// is skipped: coordinates are taken as they are. No unit.
///
/// Throws Error parse, with line or byte, for a malformed header or body, for bodies that do not
/// hold the points announced, for files without a point, for coordinates that are infinite or
/// exceed 1e50; Error limit for 2^32 - 1 points and for compressed data that expand so far that
/// they and the points take more than 20 times the file and 64 MB.
/// Phase "read".
Model parsePcd(std::span<const char> bytes, std::string_view name, Execution& execution);

/// Whether a file that starts with `head` is a PCD file: its first line that is no comment is
/// VERSION or FIELDS, or its comment says so.
bool looksLikePcd(std::span<const char> head);

} // namespace scan
