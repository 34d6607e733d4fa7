// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/error.h"

#include <cstdint>
#include <limits>
#include <string>

namespace scan
{

/// A size or number for a field of four bytes, the largest of which many formats keep for others.
/// @param complaint the message for a number that does not fit: file, what, whose limit
/// Throws Error limit.
inline std::uint32_t fourBytes(std::uint64_t number, const std::string& complaint)
{
  if (number >= std::numeric_limits<std::uint32_t>::max())
  {
    throw Error(ErrorCode::limit, complaint + "; decimate, or write PLY");
  }
  return static_cast<std::uint32_t>(number);
}

} // namespace scan
