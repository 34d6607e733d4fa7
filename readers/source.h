// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace scan
{

/// The bytes of a file and the name that messages give it.
struct Source
{
  std::string_view name;
  std::span<const char> bytes;

  const char* begin() const { return this->bytes.data(); }
  const char* end() const { return this->bytes.data() + this->bytes.size(); }

  /// Throws Error parse "name: line n: what"; `at` points into the bytes.
  [[noreturn]] void failAtLine(const char* at, const std::string& what) const;

  /// Throws Error parse "name: byte n: what", bytes counted from 0.
  [[noreturn]] void failAtByte(const char* at, const std::string& what) const;

  /// Throws Error parse "name: what".
  [[noreturn]] void fail(const std::string& what) const;

  /// Throws Error limit for more points than a model can hold, 2^32 - 2.
  void checkPointCount(std::uint64_t count) const;
};

} // namespace scan
