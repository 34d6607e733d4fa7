// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/digibotics.h"

#include "tests/readers/parsing.h"

#include <gtest/gtest.h>

namespace
{

using scan::Model;
using scan::Vec3;

Model parse(std::string_view text)
{
  return scan::test::parse(scan::parseDigibotics, text);
}

std::string error(std::string_view text)
{
  return scan::test::parseError(scan::parseDigibotics, text);
}

bool contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

bool claims(std::string_view text)
{
  return scan::looksLikeDigibotics(text);
}

const std::vector<Vec3> kPoints = { { 0.5, 0, 1 }, { 0, 0.5, 1 }, { 0.5, 0, 2 },
  { -0.25, 0.5, 2 } };
const std::string kText = "Digibot II\nUNITS: INCH\n\nSLICE 1\n0.5 0 1\n0 0.5 1\n"
                          "SLICE 2\n0.5 0 2\n-2.5e-1 .5 2\n";

} // namespace

TEST(Digibotics, ReadsTheSlicesInOrder)
{
  const Model model = parse(kText);
  EXPECT_EQ(model.points, kPoints);
  EXPECT_TRUE(model.triangles.empty());
  EXPECT_EQ(model.millimetresPerUnit, 25.4);
}

TEST(Digibotics, AcceptsEverySeparator)
{
  EXPECT_EQ(
    parse("0.5,0,1\r\n0, 0.5, 1\r\n\r\n0.5;0;2\r\n-0.25\t0.5 \t 2\r\n\x1a").points, kPoints);
  EXPECT_EQ(parse("\xef\xbb\xbf# c\n2\n0.5 0 1 7\n0 0.5 1\n; c\n2\n! c\n0.5 0 2\n// c\n"
                  "-0.25 0.5 2 7 8 9")
              .points,
    kPoints);
}

TEST(Digibotics, SkipsAColumnThatCountsThePoints)
{
  EXPECT_EQ(parse("1 0.5 0 1\n2 0 0.5 1\n3 0.5 0 2\n4 -0.25 0.5 2\n").points, kPoints);
  EXPECT_EQ(parse("slice\n0 .5 0 1\n1 0 .5 1\n2 .5 0 2\n3 -.25 .5 2\nslice\n0,4,5,6\n1,7,8,9\n"
                  "2,7,8,9\n3,7,8,9\n")
              .points[4],
    (Vec3{ 4, 5, 6 }));
  EXPECT_EQ(
    parse("1 2 3 9\n1.5 2 3 9\n").points, (std::vector<Vec3>{ { 1, 2, 3 }, { 1.5, 2, 3 } }));
  EXPECT_EQ(parse("1 2 3 9\n2 2 3\n").points, (std::vector<Vec3>{ { 1, 2, 3 }, { 2, 2, 3 } }));
}

TEST(Digibotics, KeepsAFirstCoordinateThatLooksLikeANumber)
{
  EXPECT_EQ(parse("0 2 3 9\n0 3 3 9\n0 4 3 9\n").points,
    (std::vector<Vec3>{ { 0, 2, 3 }, { 0, 3, 3 }, { 0, 4, 3 } }));
  EXPECT_EQ(parse("1.0 2 3 9\n2.0 3 3 9\n3.0 4 3 9\n4.0 0 0 0\n").points[3], (Vec3{ 4, 0, 0 }));
  EXPECT_EQ(parse("1 2 3 9\n").points[0], (Vec3{ 1, 2, 3 }));
  EXPECT_EQ(parse("0 2 3 9\n1 2 3 9\n0 5 3 9\n1 5 3 9\n").points[3], (Vec3{ 1, 5, 3 }));
}

TEST(Digibotics, TakesTheUnitFromAHeaderWord)
{
  const auto unit = [](const std::string& header)
  { return parse(header + "\n1 2 3\n4 5 6\n7 8 9\n").millimetresPerUnit; };
  EXPECT_EQ(unit("scan of a tooth"), 0.0);
  EXPECT_EQ(unit("# all values (mm)"), 1.0);
  EXPECT_EQ(unit("cm"), 10.0);
  EXPECT_EQ(unit("in"), 25.4);
  EXPECT_EQ(unit("Units=IN"), 25.4);
  EXPECT_EQ(unit("scanned in Austin"), 0.0);
  EXPECT_EQ(unit("points in millimeters"), 1.0);
  EXPECT_EQ(unit("resolution 0.1 mm\nunits inches"), 25.4);
  EXPECT_EQ(parse("1 2 3\nmm\n4 5 6\n").millimetresPerUnit, 0.0);
}

TEST(Digibotics, RefusesBinaryFilesAndAsksForASample)
{
  const std::string message = error(std::string("DBT\0\1\2\3", 7));
  EXPECT_TRUE(contains(message, "binary form of Digibotics files is not documented"));
  EXPECT_TRUE(contains(message, "send a sample file"));
}

TEST(Digibotics, NamesTheLineThatIsNoPoint)
{
  EXPECT_EQ(error("slice 1\n1 2 3\n1 2\n"),
    "file: line 3: expected x y z, found '1 2'; correct or remove the line");
  EXPECT_TRUE(contains(error("1 2 x\n"), "line 1"));
  EXPECT_TRUE(contains(error("1 x\n"), "line 1"));
  EXPECT_TRUE(contains(error("1,5 2,5 3,5\n"), "decimal commas"));
  EXPECT_TRUE(contains(error("1,5;-2,5;3,5\n"), "decimal commas"));
  EXPECT_EQ(parse("1.0,2,3 0.5\n").points, (std::vector<Vec3>{ { 1, 2, 3 } }));
}

TEST(Digibotics, RefusesOtherText)
{
  EXPECT_TRUE(contains(error(""), "no point found"));
  EXPECT_TRUE(contains(error("Dear all\n1\n"), "no point found"));
  EXPECT_EQ(error("one\ntwo\n1 2 3\n"),
    "file: only 1 lines are points, but 2 start with a word; this is no Digibotics text that can "
    "be read, export it as XYZ");
  EXPECT_TRUE(contains(error("1 2 3\n1 inf 2\n"), "1 of 2 points"));
  EXPECT_TRUE(contains(error("\xff\xfe\x31"), "UTF-16"));
}

TEST(Digibotics, SaysThatItIsNotVerified)
{
  EXPECT_TRUE(contains(parse(kText).note, "was not verified; check a known size"));
}

TEST(Digibotics, ClaimsOnlyContours)
{
  EXPECT_TRUE(claims(kText));
  EXPECT_TRUE(claims("# Digibot\n1 2 3\n"));
  EXPECT_TRUE(claims("1 2 3\nContour 2\n4 5 6\n"));
  EXPECT_FALSE(claims("1 2 3 4 5 6\n# layer 2\n4 5 6 7 8 9\n")); // a vertex list with colours
  EXPECT_FALSE(claims("Section X Y Z R G B\n1 2 3 4 5 6\n"));
  EXPECT_FALSE(claims("# Units: mm\n1 2 3\n")); // a vertex list, perhaps with colours
  EXPECT_FALSE(claims("# Profile data\n1 2 3\n"));
  EXPECT_FALSE(claims(""));
  EXPECT_FALSE(claims("1 2 3\n4 5 6\n"));
  EXPECT_FALSE(claims("# saved in Austin\nx y z\n1 2 3\n"));
  EXPECT_FALSE(claims("# a slice of bread\n1 2 3\n"));
  EXPECT_FALSE(claims("0\nSECTION\n2\nHEADER\n9\n"));
  EXPECT_FALSE(claims("# units mm\nv 1 2 3\n"));
  EXPECT_FALSE(claims(std::string_view("slice 1\n1 2 3\n\0", 16)));
}

TEST(Digibotics, EndsInErrorOrPointsWhateverTheBytes)
{
  for (std::size_t size = 0; size < kText.size(); ++size)
  {
    EXPECT_NE(error(kText.substr(0, size)), "not a parse error");
  }
  for (std::size_t at = 0; at < kText.size(); ++at)
  {
    for (int value = 0; value < 256; ++value)
    {
      std::string changed = kText;
      changed[at] = static_cast<char>(value);
      EXPECT_NE(error(changed), "not a parse error");
      claims(changed);
    }
  }
}
