// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>

namespace scan
{

/// XXH3 of 128 bits, in its canonical order of bytes: tells data apart, no proof against forgery.
/// https://github.com/Cyan4973/xxHash/blob/dev/doc/xxhash_spec.md
struct Hash
{
  std::array<char, 16> bytes{};

  friend bool operator==(const Hash&, const Hash&) = default;
  friend bool operator<(const Hash& a, const Hash& b) { return a.bytes < b.bytes; }
};

Hash hashOf(std::span<const char> bytes);

/// 32 hexadecimal digits.
std::string textOf(const Hash& hash);

/// The hash of the bytes of a file. Throws Error io.
Hash hashOfFile(const std::string& path);

} // namespace scan
