// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/model.h"

#include <span>
#include <string_view>

namespace scan
{

/// Reads a LAS point cloud (ASPRS LAS 1.0 to 1.4), uncompressed.
///
/// Coordinates are the file's integers times its scale plus its offset, in double precision. Point
/// formats 2, 3, 5, 7, 8 and 10 have colours of 16 bits, of which the upper 8 are kept, unless the
/// whole file uses the lower 8 only; a file whose colours are all 0 has none. Of formats that are
/// not known, above 10, the coordinates are read. Points that are marked as withheld, that is
/// deleted, are left out. The unit is that of the file's coordinate system, as GeoTIFF keys or as
/// text; unknown where the file does not say, where it has angles, and where heights have another.
///
/// Throws Error parse, with the byte, for a malformed header, for more points than the file holds,
/// for a file without points, for compressed files (LAZ), for coordinates that are not finite or
/// exceed 1e50; Error limit for 2^32 - 1 points. Phase "read".
Model parseLas(std::span<const char> bytes, std::string_view name, Execution& execution);

/// Whether the file is of this format, compressed or not.
bool looksLikeLas(std::span<const char> head);

} // namespace scan
