// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/lzf.h"

#include <algorithm>
#include <cstddef>

namespace scan
{
namespace
{

constexpr unsigned kLiterals = 32; // control bytes below start a run of literals
constexpr std::size_t kLongLength = 7;
constexpr std::size_t kStepBytes = std::size_t(1) << 20U;

} // namespace

bool expandLzf(std::span<const char> input, std::span<char> output, Execution& execution)
{
  std::size_t in = 0;
  std::size_t out = 0;
  std::size_t reported = 0;
  const auto take = [&] { return static_cast<unsigned char>(input[in++]); };
  while (in < input.size())
  {
    if (in >= reported)
    {
      execution.step("read", in, 2 * input.size());
      reported = in + kStepBytes;
    }
    const unsigned control = take();
    if (control < kLiterals)
    {
      const std::size_t length = control + 1;
      if (length > input.size() - in || length > output.size() - out)
      {
        return false;
      }
      std::copy_n(input.data() + in, length, output.data() + out);
      in += length;
      out += length;
      continue;
    }
    std::size_t length = control >> 5U;
    const bool isLong = length == kLongLength;
    if (input.size() - in < (isLong ? 2U : 1U))
    {
      return false;
    }
    length += isLong ? take() : 0U;
    length += 2;
    const std::size_t distance = ((control & 31U) << 8U) + take() + 1;
    if (distance > out || length > output.size() - out)
    {
      return false;
    }
    // byte by byte: the copy may reach into what it writes
    for (const std::size_t stop = out + length; out < stop; ++out)
    {
      output[out] = output[out - distance];
    }
  }
  return out == output.size();
}

} // namespace scan
