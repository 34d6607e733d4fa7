// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/text_scanner.h"

#include <charconv>
#include <limits>
#include <system_error>

namespace scan
{
namespace
{

/// Whether a number that does not fit a double is too large rather than too small.
bool isHuge(const char* at, const char* end)
{
  const char* const exponentMark =
    std::find_if(at, end, [](char c) { return c == 'e' || c == 'E'; });
  const char* const point = std::find(at, exponentMark, '.');
  const char* const first =
    std::find_if(at, exponentMark, [](char c) { return c >= '1' && c <= '9'; });
  // the power of ten of the first digit that counts, without the exponent
  double power = static_cast<double>(point - first);
  if (exponentMark != end)
  {
    const char* number = exponentMark + 1;
    const bool negative = number != end && *number == '-';
    number += number != end && (*number == '-' || *number == '+');
    int exponent = 0;
    if (std::from_chars(number, end, exponent).ec == std::errc::result_out_of_range)
    {
      exponent = std::numeric_limits<int>::max();
    }
    power += negative ? -static_cast<double>(exponent) : static_cast<double>(exponent);
  }
  return power > 0.0;
}

} // namespace

std::size_t lineNumber(const char* begin, const char* at)
{
  std::size_t line = 1;
  for (const char* c = begin; c < at; ++c)
  {
    line += *c == '\n' || (*c == '\r' && (c + 1 == at || c[1] != '\n'));
  }
  return line;
}

std::string quoted(std::string_view text)
{
  constexpr std::size_t kLongest = 30;
  std::string result = "'";
  for (const char c : text.substr(0, kLongest))
  {
    result += c >= ' ' && c <= '~' ? c : '?';
  }
  return result + (text.size() > kLongest ? "...'" : "'");
}

std::string lowerCase(std::string_view text)
{
  std::string lower(text);
  std::ranges::transform(lower, lower.begin(), [](char c) { return lowerCase(c); });
  return lower;
}

const char* skipUtf8Mark(std::span<const char> text)
{
  const bool isMarked = std::string_view(text.data(), text.size()).starts_with("\xef\xbb\xbf");
  return text.data() + (isMarked ? 3 : 0);
}

const char* skipByteOrderMark(const Source& source)
{
  const std::string_view text(source.begin(), source.bytes.size());
  if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff"))
  {
    source.fail("the text is encoded as UTF-16; save it as UTF-8 or plain text");
  }
  return skipUtf8Mark(source.bytes);
}

Source textOf(std::string_view name, std::span<const char> bytes)
{
  std::size_t size = bytes.size();
  while (size > 0 && (bytes[size - 1] == '\x1a' || bytes[size - 1] == '\0'))
  {
    --size;
  }
  return { name, bytes.first(size) };
}

const char* parseAnyNumber(const char* at, const char* end, double& value)
{
  const bool negative = at != end && *at == '-';
  at += at != end && (*at == '-' || *at == '+');
  if (at == end || *at == '-')
  {
    return nullptr;
  }
  double magnitude = 0.0;
  const std::from_chars_result result = std::from_chars(at, end, magnitude);
  if (result.ec == std::errc::invalid_argument)
  {
    return nullptr;
  }
  if (result.ec == std::errc::result_out_of_range)
  {
    magnitude = isHuge(at, result.ptr) ? std::numeric_limits<double>::infinity() : 0.0;
  }
  value = negative ? -magnitude : magnitude;
  return result.ptr;
}

} // namespace scan
