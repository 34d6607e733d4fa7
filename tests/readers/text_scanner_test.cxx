// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/text_scanner.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <clocale>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <locale>
#include <random>

namespace
{

double number(std::string_view text)
{
  double value = std::numeric_limits<double>::quiet_NaN();
  const char* const end = text.data() + text.size();
  return scan::parseNumber(text.data(), end, value) == end
    ? value
    : std::numeric_limits<double>::quiet_NaN();
}

struct CommaPoint : std::numpunct<char>
{
  char do_decimal_point() const override { return ','; }
};

} // namespace

TEST(ParseNumber, ReadsTheUsualForms)
{
  EXPECT_EQ(number("0"), 0.0);
  EXPECT_EQ(number("+1.5"), 1.5);
  EXPECT_EQ(number("-2."), -2.0);
  EXPECT_EQ(number(".5"), 0.5);
  EXPECT_EQ(number("1e2"), 100.0);
  EXPECT_EQ(number("1E+2"), 100.0);
  EXPECT_EQ(number("-12.5e-1"), -1.25);
  EXPECT_TRUE(std::signbit(number("-0")));
}

TEST(ParseNumber, TellsHugeFromTiny)
{
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(number("1e999"), infinity);
  EXPECT_EQ(number("-0.001e999"), -infinity);
  EXPECT_EQ(number("1e-999"), 0.0);
  EXPECT_EQ(number("1e99999999999999999999"), infinity);
  EXPECT_EQ(number("1e-99999999999999999999"), 0.0);
  EXPECT_EQ(number("+inf"), infinity);
  EXPECT_EQ(number("-Inf"), -infinity);
}

TEST(ParseNumber, RefusesWhatIsNoNumber)
{
  for (const char* const text :
    { "", "+", "-", ".", "e5", "+-5", "--5", "0x10", "1e", "1.2.3", "1,5" })
  {
    EXPECT_TRUE(std::isnan(number(text))) << text;
  }
}

TEST(ParseNumber, IsCorrectlyRounded)
{
  const unsigned seed = 20240711;
  std::mt19937_64 random(seed);
  for (int i = 0; i < 200000; ++i)
  {
    // every exponent with 17 digits, and everyday numbers with up to 15 decimals
    const auto any = std::bit_cast<double>(random());
    const double everyday = static_cast<double>(static_cast<std::int64_t>(random())) * 1e-14;
    std::array<char, 64> text = {};
    std::snprintf(text.data(), text.size(), "%.*g", 17, any);
    ASSERT_TRUE(!std::isfinite(any) || number(text.data()) == std::strtod(text.data(), nullptr))
      << text.data() << " (seed " << seed << ")";
    std::snprintf(text.data(), text.size(), "%.*f", i % 16, everyday);
    ASSERT_EQ(number(text.data()), std::strtod(text.data(), nullptr)) << "seed " << seed;
  }
}

TEST(ParseNumber, IgnoresTheLocale)
{
  const std::locale before = std::locale::global(std::locale(std::locale(), new CommaPoint));
  const std::string cBefore = std::setlocale(LC_NUMERIC, nullptr);
  for (const char* const name : { "de_DE.UTF-8", "de_DE", "fr_FR.UTF-8" })
  {
    std::setlocale(LC_NUMERIC, name); // where it is installed
  }
  EXPECT_EQ(number("1.5"), 1.5);
  EXPECT_EQ(number("1.234567890123456789e-3"), 1.234567890123456789e-3);
  std::setlocale(LC_NUMERIC, cBefore.c_str());
  std::locale::global(before);
}

TEST(LineNumber, CountsEveryKindOfLineEnd)
{
  const std::string text = "a\nb\r\nc\rd";
  const auto line = [&](char c) { return scan::lineNumber(text.data(), &text[text.find(c)]); };
  EXPECT_EQ(line('a'), 1U);
  EXPECT_EQ(line('b'), 2U);
  EXPECT_EQ(line('c'), 3U);
  EXPECT_EQ(line('d'), 4U);
}
