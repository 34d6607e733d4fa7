// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace scan
{

/// A line of an IGES file: 72 columns of data, the letter of its section, its number there.
class IgesLine
{
public:
  static constexpr std::size_t kData = 72;
  static constexpr std::uint64_t kLargestNumber = 9'999'999;

  IgesLine(char section, std::uint64_t number)
  {
    this->Characters.fill(' ');
    this->Characters[kData] = section;
    this->Characters.back() = '\n';
    this->number(kData + 8, number);
  }

  IgesLine& text(std::size_t begin, std::string_view text)
  {
    text.copy(this->Characters.data() + begin, text.size());
    return *this;
  }

  /// Right-justified before the column `end`.
  IgesLine& number(std::size_t end, std::uint64_t value)
  {
    std::array<char, 20> digits;
    const char* const last = std::to_chars(digits.begin(), digits.end(), value).ptr;
    const auto size = static_cast<std::size_t>(last - digits.data());
    return this->text(end - size, { digits.data(), size });
  }

  operator std::string_view() const { return { this->Characters.data(), this->Characters.size() }; }

private:
  std::array<char, 81> Characters;
};

} // namespace scan
