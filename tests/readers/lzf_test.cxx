// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/lzf.h"

#include "filters/base/error.h"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

namespace
{

/// The expanded bytes; nothing when the data are refused.
std::optional<std::string> expand(const std::string& packed, std::size_t size)
{
  const std::vector<char> input(packed.begin(), packed.end());
  std::vector<char> output(size);
  scan::Execution execution(1);
  const bool isGood = scan::expandLzf(input, output, execution);
  return isGood ? std::optional(std::string(output.begin(), output.end())) : std::nullopt;
}

} // namespace

TEST(Lzf, CopiesLiterals)
{
  EXPECT_EQ(expand(std::string("\2abc\0d", 6), 4), "abcd");
  EXPECT_EQ(expand("\x1f" + std::string(32, 'x'), 32), std::string(32, 'x'));
  EXPECT_EQ(expand("", 0), "");
}

TEST(Lzf, RepeatsWhatCameBefore)
{
  EXPECT_EQ(expand(std::string("\2abc\x20\2", 6), 6), "abcabc");      // three bytes, three back
  EXPECT_EQ(expand(std::string("\2abc\xa0\1", 6), 10), "abcbcbcbcb"); // into what it writes
  EXPECT_EQ(expand(std::string("\0a\xe0\xff\0", 5), 265), std::string(265, 'a')); // longest
}

TEST(Lzf, ReachesBackEightThousandBytes)
{
  std::string packed;
  std::string expected;
  for (int i = 0; i < 256; ++i)
  {
    const std::string part = std::string(31, static_cast<char>(i)) + "|";
    packed += "\x1f" + part;
    expected += part;
  }
  EXPECT_EQ(expand(packed + "\x3f\xff", 8195), expected + expected.substr(0, 3));
}

TEST(Lzf, RefusesMalformedData)
{
  EXPECT_FALSE(expand("\2ab", 3));                            // too few literals
  EXPECT_FALSE(expand("\2abc", 2));                           // too small an output
  EXPECT_FALSE(expand("\2abc", 4));                           // too large an output
  EXPECT_FALSE(expand("\2abc\x20", 6));                       // cut off
  EXPECT_FALSE(expand("\2abc\xe0\1", 13));                    // cut off
  EXPECT_FALSE(expand("\2abc\x20\3", 6));                     // in front of the start
  EXPECT_FALSE(expand(std::string("\x20\0", 2), 3));          // nothing to repeat
  EXPECT_FALSE(expand(std::string("\0a\xe0\xff\0", 5), 264)); // beyond the end
}

TEST(Lzf, StopsWhenCancelled)
{
  scan::CancelToken token;
  token.cancel();
  scan::Execution execution(1, token);
  std::vector<char> output(3);
  EXPECT_THROW(scan::expandLzf(std::string("\2abc"), output, execution), scan::Cancelled);
}
