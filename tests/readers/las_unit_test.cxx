// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/las_unit.h"

#include <gtest/gtest.h>

#include <initializer_list>
#include <string>
#include <utility>

namespace
{

/// A GeoTIFF directory of keys with their values in place.
std::string directory(std::initializer_list<std::pair<int, int>> keys)
{
  std::string result;
  const auto add = [&](int a, int b, int c, int d)
  {
    for (const int value : { a, b, c, d })
    {
      result += static_cast<char>(value & 255);
      result += static_cast<char>(value >> 8);
    }
  };
  add(1, 1, 0, static_cast<int>(keys.size()));
  for (const auto& [key, value] : keys)
  {
    add(key, 0, 1, value);
  }
  return result;
}

} // namespace

TEST(LasUnit, IsThatOfTheProjectedKey)
{
  const auto unit = [](std::initializer_list<std::pair<int, int>> keys)
  { return scan::geoKeyUnit(directory(keys)); };
  EXPECT_EQ(unit({ { 1024, 1 }, { 3072, 32617 }, { 3076, 9001 } }), 1000.0);
  EXPECT_EQ(unit({ { 3076, 9002 } }), 304.8);
  EXPECT_NEAR(unit({ { 3076, 9003 } }), 304.8006096, 1e-7);
  EXPECT_EQ(unit({ { 3076, 9001 }, { 4099, 9001 } }), 1000.0);
}

TEST(LasUnit, IsUnknownWhereTheKeysDoNotSay)
{
  EXPECT_EQ(scan::geoKeyUnit(directory({ { 3076, 9001 }, { 4099, 9002 } })), 0.0);
  EXPECT_EQ(scan::geoKeyUnit(directory({ { 1024, 2 }, { 2054, 9102 } })), 0.0);
  EXPECT_EQ(scan::geoKeyUnit(directory({ { 3076, 9102 } })), 0.0);
  EXPECT_EQ(scan::geoKeyUnit(directory({ { 3076, 9001 } }).substr(0, 15)), 0.0);
  EXPECT_EQ(scan::geoKeyUnit({}), 0.0);
}

TEST(LasUnit, IsThatOfTheProjectedSystemInText)
{
  const std::string system =
    "PROJCS[\"a UNIT[\",GEOGCS[\"b\",UNIT[\"degree\",0.0174532925]],"
    "PROJECTION[\"c\"],UNIT[\"foot\", 0.3048,AUTHORITY[\"EPSG\",\"9002\"]]]";
  const auto compound = [&](const std::string& metres)
  { return "COMPD_CS[\"d\"," + system + ",VERT_CS[\"e\",UNIT[\"height\"," + metres + "]]]"; };
  EXPECT_EQ(scan::wellKnownTextUnit(system), 304.8);
  EXPECT_EQ(scan::wellKnownTextUnit(compound("0.3048")), 304.8);
  EXPECT_EQ(scan::wellKnownTextUnit(compound("1")), 0.0);
  EXPECT_EQ(scan::wellKnownTextUnit("GEOGCS[\"b\",UNIT[\"degree\",0.0174532925]]"), 0.0);
  EXPECT_EQ(scan::wellKnownTextUnit("PROJCS[\"a\",UNIT[\"metre\""), 0.0);
  EXPECT_EQ(scan::wellKnownTextUnit("PROJCS[\"a\",UNIT[\"metre\",x]]"), 0.0);
  EXPECT_EQ(scan::wellKnownTextUnit(""), 0.0);
}
