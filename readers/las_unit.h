// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>

namespace scan
{

/// The unit in a GeoTIFF key directory: little-endian 16-bit numbers, four a key.
/// @return millimetres; 0 when the unit is not there, not known or not that of the heights
double geoKeyUnit(std::span<const char> directory);

/// The unit of the projected system in the well-known text of a coordinate system (WKT 1).
/// @return millimetres; 0 when there is none or when it is not that of the heights
double wellKnownTextUnit(std::string_view text);

} // namespace scan
