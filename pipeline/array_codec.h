// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace scan
{

/// How the values of an array lie in memory, so that they compress well.
struct ValueLayout
{
  std::size_t width = 1;      ///< bytes of a value: 1, 2, 4 or 8
  std::size_t components = 1; ///< values of a tuple, up to 65535
  bool isInteger = true;
};

/// Compresses a part of an array that starts with a whole tuple. The code starts with four bytes.
/// The first one names the way: 0 as it is, 1 Zstandard; 2 Zstandard of the values byte by byte,
/// all lowest bytes first; 3 the same of the differences to the tuple before. Then the bytes of a
/// value, and the values of a tuple in two bytes, the lower one first.
std::vector<char> encodeValues(std::span<const char> values, const ValueLayout& layout);

/// @throws Error parse when the bytes are not the code of values that fill `values`
void decodeValues(std::span<const char> code, std::span<char> values);

} // namespace scan
