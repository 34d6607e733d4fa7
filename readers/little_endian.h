// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bit>
#include <cstring>

namespace scan
{

/// The little-endian number at `at`, which need not be aligned.
template <class Number>
Number loadLittle(const char* at)
{
  static_assert(std::endian::native == std::endian::little);
  Number value;
  std::memcpy(&value, at, sizeof(value));
  return value;
}

} // namespace scan
