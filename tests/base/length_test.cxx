// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/base/length.h"

#include "filters/base/error.h"

#include <gtest/gtest.h>

#include <clocale>

using scan::Length;
using scan::LengthScale;

namespace
{

const LengthScale kCentimetreModel{ .diagonal = 200.0, .spacing = 0.5, .millimetresPerUnit = 10.0 };

double resolved(std::string_view text)
{
  return Length::parse(text).resolve(kCentimetreModel);
}

} // namespace

TEST(Length, ResolvesEveryUnitAgainstTheModel)
{
  EXPECT_DOUBLE_EQ(resolved("0.5"), 0.5);
  EXPECT_DOUBLE_EQ(resolved("1%"), 2.0);
  EXPECT_DOUBLE_EQ(resolved("3x"), 1.5);
  EXPECT_DOUBLE_EQ(resolved("500um"), 0.05);
  EXPECT_DOUBLE_EQ(resolved("5mm"), 0.5);
  EXPECT_DOUBLE_EQ(resolved("5cm"), 5.0);
  EXPECT_DOUBLE_EQ(resolved("0.5m"), 50.0);
  EXPECT_DOUBLE_EQ(resolved("1in"), 2.54);
  EXPECT_DOUBLE_EQ(resolved("-1.5e1mm"), -1.5);
}

TEST(Length, PrintsWhatItParses)
{
  for (const char* text : { "0.5", "1%", "3x", "0.1mm", "-2cm", "1e-07m", "25.4in", "7um" })
  {
    EXPECT_EQ(Length::parse(text).text(), text);
  }
}

TEST(Length, RefusesNonsense)
{
  for (const char* text :
    { "", "mm", "1 mm", " 1", "1mm ", "1,5mm", "nan", "inf", "1e999", "0x10", "1parsec", "1%%" })
  {
    try
    {
      Length::parse(text);
      ADD_FAILURE() << "'" << text << "' was taken for a length";
    }
    catch (const scan::Error& error)
    {
      EXPECT_EQ(error.code(), scan::ErrorCode::badParameter) << text;
    }
  }
}

TEST(Length, RefusesToBeRelativeToNothing)
{
  EXPECT_THROW(Length::parse("1%").resolve({}), scan::Error);
  EXPECT_THROW(Length::parse("1x").resolve({}), scan::Error);
  EXPECT_DOUBLE_EQ(Length::parse("1mm").resolve({}), 1.0);
}
