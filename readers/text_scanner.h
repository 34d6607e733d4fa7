// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "readers/source.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

/// Scanning of text in memory, always in the "C" locale. Lines end with LF, CRLF or CR. All
/// functions take [at, end) and never read beyond end; the text need not end with a line end.
namespace scan
{

inline bool isBlank(char c)
{
  return c == ' ' || c == '\t';
}

inline bool isLineEnd(char c)
{
  return c == '\n' || c == '\r';
}

/// A character that may stand between two columns.
inline bool isSeparator(char c)
{
  return isBlank(c) || c == ',' || c == ';';
}

inline bool isDigit(char c)
{
  return static_cast<unsigned char>(c - '0') < 10;
}

inline const char* skipBlanks(const char* at, const char* end)
{
  while (at != end && isBlank(*at))
  {
    ++at;
  }
  return at;
}

/// Blanks and line ends.
inline const char* skipSpace(const char* at, const char* end)
{
  while (at != end && (isBlank(*at) || isLineEnd(*at)))
  {
    ++at;
  }
  return at;
}

/// The line end at or behind `at`, or end.
inline const char* findLineEnd(const char* at, const char* end)
{
  while (at != end && !isLineEnd(*at))
  {
    ++at;
  }
  return at;
}

/// The start of the next line, or end.
inline const char* nextLine(const char* at, const char* end)
{
  at = findLineEnd(at, end);
  if (at != end && *at == '\r')
  {
    ++at;
    return at != end && *at == '\n' ? at + 1 : at;
  }
  return at != end ? at + 1 : at;
}

/// The characters up to the next blank or line end.
inline std::string_view word(const char* at, const char* end)
{
  const char* stop = std::find_if(at, end, [](char c) { return isBlank(c) || isLineEnd(c); });
  return { at, static_cast<std::size_t>(stop - at) };
}

/// The number of the line that `at` lies in, from 1.
std::size_t lineNumber(const char* begin, const char* at);

/// Letters A to Z become small, whatever the locale.
inline char lowerCase(char c)
{
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

std::string lowerCase(std::string_view text);

/// A quoted excerpt for messages: unprintable characters shown as '?', long text cut.
std::string quoted(std::string_view text);

/// The first character behind a UTF-8 byte order mark, if there is one.
const char* skipUtf8Mark(std::span<const char> text);

/// The same; throws Error parse for UTF-16 text.
const char* skipByteOrderMark(const Source& source);

/// Text without what ends it in old systems: Ctrl-Z, and zeros up to the end of a block.
Source textOf(std::string_view name, std::span<const char> bytes);

/// Reads the digits at `at` and appends them to the mantissa, modulo 2^64.
/// @return the character behind the digits
inline const char* readDigits(const char* at, const char* end, std::uint64_t& mantissa)
{
  static_assert(std::endian::native == std::endian::little);
  static constexpr std::uint64_t kPowers[] = { 1, 10, 100, 1000, 10000, 100000, 1000000, 10000000,
    100000000 };
  // Eight characters at once, without a branch on their number: scans are read at memory speed.
  while (end - at >= 8)
  {
    std::uint64_t eight = 0;
    std::memcpy(&eight, at, sizeof(eight));
    eight ^= 0x3030303030303030U; // digits become 0 to 9
    const std::uint64_t others =
      ((eight + 0x0606060606060606U) | eight) & 0xf0f0f0f0f0f0f0f0U; // exact up to the first
    const int count = std::countr_zero(others) / 8;
    if (count == 0)
    {
      return at;
    }
    eight <<= 64 - 8 * count;
    eight = eight * 10 + (eight >> 8U); // pairs of digits, then fours, then the number
    eight = ((eight & 0x000000ff000000ffU) * 0x000f424000000064U +
              ((eight >> 16U) & 0x000000ff000000ffU) * 0x0000271000000001U) >>
      32U;
    mantissa = mantissa * kPowers[count] + eight;
    at += count;
    if (count < 8)
    {
      return at;
    }
  }
  for (; at != end && isDigit(*at); ++at)
  {
    mantissa = mantissa * 10 + static_cast<std::uint64_t>(*at - '0');
  }
  return at;
}

/// parseNumber for the rare cases: many digits, large exponents, inf and nan.
const char* parseAnyNumber(const char* at, const char* end, double& value);

/// Parses a decimal number, correctly rounded: an optional sign, digits with an optional point,
/// an optional exponent; also inf and nan in any case. Too large is infinity, too small is 0.
/// @return the character behind the number, nullptr when there is none
inline const char* parseNumber(const char* at, const char* end, double& value)
{
  // Up to 2^53 the mantissa is exact, and so are powers of ten up to 10^22: one rounding.
  static constexpr double kPowers[] = { 1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10,
    1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22 };
  const char* const start = at;
  const bool negative = at != end && *at == '-';
  at += at != end && (*at == '-' || *at == '+');
  std::uint64_t mantissa = 0;
  const char* const whole = at;
  at = readDigits(at, end, mantissa);
  std::ptrdiff_t digits = at - whole;
  std::ptrdiff_t decimals = 0;
  if (at != end && *at == '.')
  {
    const char* const fraction = ++at;
    at = readDigits(at, end, mantissa);
    decimals = at - fraction;
    digits += decimals;
  }
  const bool hasExponent = at != end && (*at == 'e' || *at == 'E');
  if (digits == 0 || digits > 19 || hasExponent || decimals > 22 || mantissa > (1ULL << 53U))
  {
    return parseAnyNumber(start, end, value);
  }
  const double magnitude = static_cast<double>(mantissa) / kPowers[decimals];
  // no branch: the sign of a coordinate is hard to predict
  value = std::bit_cast<double>(
    std::bit_cast<std::uint64_t>(magnitude) | (static_cast<std::uint64_t>(negative) << 63U));
  return at;
}

} // namespace scan
