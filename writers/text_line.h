// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <charconv>
#include <cstddef>
#include <string_view>

namespace scan
{

/// One line of text with numbers in the "C" locale; never allocates. Numbers take the fewest digits
/// that read back as the same value.
class TextLine
{
public:
  static constexpr std::size_t kCapacity = 160;

  explicit TextLine(std::string_view start = {}) { this->text(start); }

  TextLine& text(std::string_view text)
  {
    text.copy(this->Characters + this->Size, kCapacity - this->Size);
    this->Size += text.size();
    return *this;
  }

  /// The number, behind a blank unless it starts the line.
  template <class Number>
  TextLine& number(Number value)
  {
    return this->text(this->Size > 0 ? " " : "").digits(value);
  }

  /// The number without a blank.
  template <class Number>
  TextLine& digits(Number value)
  {
    char* const end = this->Characters + kCapacity;
    this->Size = static_cast<std::size_t>(
      std::to_chars(this->Characters + this->Size, end, value).ptr - this->Characters);
    return *this;
  }

  operator std::string_view() const { return { this->Characters, this->Size }; }

private:
  char Characters[kCapacity];
  std::size_t Size = 0;
};

} // namespace scan
