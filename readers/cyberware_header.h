// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "readers/source.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace scan
{

enum class CyberwareSpace
{
  cylindrical, ///< a radius per angle and height
  cartesian,   ///< a depth per column and row
  bilateral    ///< two Cartesian maps, one in each half of the latitudes
};

/// What the header of a Cyberware Echo file says about the samples behind it.
struct CyberwareHeader
{
  std::size_t size = 0; ///< bytes ahead of the samples
  bool isBigEndian = true;
  CyberwareSpace space = CyberwareSpace::cylindrical;
  std::int64_t latitudes = 0;     ///< samples of a longitude, 1 to 32767
  std::int64_t longitudes = 0;    ///< 1 to 32767
  std::int64_t latitudeStep = 0;  ///< micrometres, positive
  std::int64_t longitudeStep = 0; ///< microradians if cylindrical, else micrometres; positive
  int shift = 0;                  ///< a sample times 2^shift is in micrometres; 0 to 16
  // the window of valid samples, both ends inclusive, within the grid
  std::int64_t firstLatitude = 0;
  std::int64_t lastLatitude = 0;
  std::int64_t firstLongitude = 0;
  std::int64_t lastLongitude = 0;
  bool isInsideOut = false;
  bool isRightHanded = false; ///< the angle follows the right-hand rule
};

/// Reads the portable header of text lines up to "DATA=", or the older binary one of 114, 122 or
/// 128 bytes in either byte order.
/// Throws Error parse, with the line or byte, when a value is missing or out of its range.
CyberwareHeader parseCyberwareHeader(const Source& source);

/// Whether a file that starts with `head` can be a Cyberware Echo file.
bool looksLikeCyberware(std::span<const char> head);

} // namespace scan
