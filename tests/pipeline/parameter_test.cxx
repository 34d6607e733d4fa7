// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/parameter.h"

#include "filters/base/error.h"

#include <gtest/gtest.h>

using namespace scan;

namespace
{

const Parameter kSwitch{ .name = "manifold", .defaultValue = true, .help = "" };
const Parameter kCount{
  .name = "steps", .defaultValue = std::int64_t{ 3 }, .help = "", .minimum = 1, .maximum = 9
};
const Parameter kReal{ .name = "ratio", .defaultValue = 0.5, .help = "", .minimum = 0 };
const Parameter kChoice{
  .name = "fit", .defaultValue = "all", .help = "", .choices = { "all", "robust" }
};
const Parameter kLength{ .name = "radius", .defaultValue = Length(1.0), .help = "", .minimum = 0 };

std::string messageOf(const Parameter& parameter, const char* text)
{
  try
  {
    parseValue(parameter, text);
  }
  catch (const Error& error)
  {
    return error.what();
  }
  return "taken";
}

} // namespace

TEST(Parameter, ParsesWhatItPrints)
{
  EXPECT_EQ(parseValue(kSwitch, "false"), ParameterValue(false));
  EXPECT_EQ(parseValue(kCount, "9"), ParameterValue(std::int64_t{ 9 }));
  EXPECT_EQ(parseValue(kReal, "1e-3"), ParameterValue(0.001));
  EXPECT_EQ(parseValue(kChoice, "robust"), ParameterValue("robust"));
  EXPECT_EQ(parseValue(kLength, "3x"), ParameterValue(Length(3.0, Length::Unit::spacing)));
  for (const auto& [parameter, text] : { std::pair{ kSwitch, "true" }, { kCount, "4" },
         { kReal, "0.125" }, { kChoice, "all" }, { kLength, "0.5mm" } })
  {
    EXPECT_EQ(textOf(parseValue(parameter, text)), text);
  }
}

TEST(Parameter, RefusalNamesTheOptionAndItsRange)
{
  EXPECT_EQ(messageOf(kSwitch, "yes"), "--manifold=yes: expected true|false");
  EXPECT_EQ(messageOf(kCount, "10"), "--steps=10: expected a whole number from 1 to 9");
  EXPECT_EQ(messageOf(kCount, "2.5"), "--steps=2.5: expected a whole number from 1 to 9");
  EXPECT_EQ(messageOf(kReal, "-1"), "--ratio=-1: expected a number from 0 up");
  EXPECT_EQ(messageOf(kChoice, "some"), "--fit=some: expected all|robust");
}

TEST(Parameter, RefusesNonsenseOfEveryType)
{
  for (const Parameter& parameter : { kSwitch, kCount, kReal, kChoice, kLength })
  {
    for (const char* text : { "", "nan", "inf", "-1", "1 ", "1,5", "9e999" })
    {
      EXPECT_NE(messageOf(parameter, text), "taken") << parameter.name << "=" << text;
    }
  }
}

TEST(Parameter, RefusesAValueOfAnotherType)
{
  EXPECT_THROW(checkValue(kCount, ParameterValue(3.0)), Error);
  EXPECT_NO_THROW(checkValue(kCount, ParameterValue(std::int64_t{ 3 })));
}
