// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/points_text.h"

#include "tests/readers/parsing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace
{

using scan::Color;
using scan::Model;
using scan::Vec3;

Model parse(std::string_view text, unsigned threads = 1)
{
  return scan::test::parse(scan::parsePointsText, text, threads);
}

/// Whether the text has points, and neither colours nor normals.
bool hasOnlyPoints(std::string_view text)
{
  const Model model = parse(text);
  return !model.points.empty() && model.colors.empty() && model.normals.empty();
}

std::vector<Vec3> points(std::string_view text)
{
  const scan::TriMesh mesh = scan::test::parse(scan::parsePointsText, text);
  EXPECT_TRUE(mesh.triangles.empty());
  return mesh.points;
}

std::string error(std::string_view text)
{
  return scan::test::parseError(scan::parsePointsText, text);
}

const std::vector<Vec3> kTwo = { { 1.0, 2.5, -3.0 }, { 4.0, 5.0, 6e-3 } };

std::string manyLines(std::size_t count, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> digit(-999999, 999999);
  std::string text = "# many\n";
  for (std::size_t i = 0; i < count; ++i)
  {
    text += std::to_string(digit(random)) + "." + std::to_string(i) + " " +
      std::to_string(digit(random)) + "e-3 0." + std::to_string(i % 7) + (i % 5 ? "\n" : "\r\n");
  }
  return text;
}

} // namespace

TEST(PointsText, AcceptsEverySeparator)
{
  EXPECT_EQ(points("1 2.5 -3\n4 5 6e-3\n"), kTwo);
  EXPECT_EQ(points("1\t2.5\t-3\n4\t5\t6e-3\n"), kTwo);
  EXPECT_EQ(points("1,2.5,-3\n4,5,6e-3\n"), kTwo);
  EXPECT_EQ(points("1;2.5;-3\n4;5;6e-3\n"), kTwo);
  EXPECT_EQ(points("  1 ,  2.5 , -3 \n4, 5,\t6e-3\n"), kTwo);
}

TEST(PointsText, AcceptsEveryLineEnd)
{
  EXPECT_EQ(points("1 2.5 -3\r\n4 5 6e-3\r\n"), kTwo);
  EXPECT_EQ(points("1 2.5 -3\r4 5 6e-3\r"), kTwo);
  EXPECT_EQ(points("1 2.5 -3\n\n\r\n4 5 6e-3"), kTwo);
}

TEST(PointsText, SkipsHeadersCountsAndComments)
{
  EXPECT_EQ(points("\xef\xbb\xbf// X Y Z\n1 2.5 -3\n4 5 6e-3\n"), kTwo);
  EXPECT_EQ(points("2\n1 2.5 -3\n4 5 6e-3\n"), kTwo);
  EXPECT_EQ(points("\"x\",\"y\",\"z\"\n1,2.5,-3\n4,5,6e-3\n"), kTwo);
  EXPECT_EQ(points("# a\n! b\n% c\nX Y Z\n2\n\n1 2.5 -3\n  # inside\n4 5 6e-3\n// end"), kTwo);
}

TEST(PointsText, IgnoresFurtherColumns)
{
  EXPECT_EQ(points("1 2.5 -3 0.1 0.2 name\n4 5 6e-3 255 nan\n"), kTwo);
  EXPECT_EQ(points("1 2.5 -3\t# first\n4 5 6e-3 // second\n"), kTwo);
}

TEST(PointsText, ReadsColorsOfSixColumns)
{
  const std::vector<Color> colors = { { 1, 2, 3 }, { 0, 255, 10 } };
  EXPECT_EQ(parse("1 2.5 -3 1 2 3\n4 5 6e-3 0 255 10\n").colors, colors);
  EXPECT_EQ(parse("//X,Y,Z,R,G,B\r\n1,2.5,-3,1.0,2.0,3.0,\r\n4,5,6e-3,0,255,1e1,").colors, colors);
  EXPECT_EQ(parse("2\n1 2.5 -3 1 2 3 # a\n\n4 5 6e-3\t0\t255\t10").points, kTwo);
  EXPECT_EQ(parse("p 1 2.5 -3 1 2 3\ns 1 1 1\np 4 5 6e-3 0 255 10\n").colors, colors);
}

TEST(PointsText, ReadsNormalsOfSixColumns)
{
  const Model model = parse("1 2.5 -3 0 1 0\n4 5 6e-3 -.59 .0 .81\n0 0 0 0 0 0\n");
  ASSERT_EQ(model.normals.size(), 3U);
  EXPECT_EQ(model.normals[0], (Vec3{ 0, 1, 0 }));
  EXPECT_DOUBLE_EQ(dot(model.normals[1], model.normals[1]), 1.0);
  EXPECT_EQ(model.normals[2], (Vec3{ 0, 0, 0 }));
  EXPECT_TRUE(model.colors.empty());
  EXPECT_EQ(parse("0 0 0 0 0 1\n1 1 1 1 0 0\n").normals.size(), 2U); // rather than nearly black
}

TEST(PointsText, ReadsColorsOfSevenColumns)
{
  const std::vector<Color> colors = { { 1, 2, 3 }, { 0, 255, 10 } };
  EXPECT_EQ(parse("1 2 3 -0.5 1 2 3\n1 2 3 4095 0 255 10\n").colors, colors);
  EXPECT_EQ(parse("1 2 3 50 1 2 3\n1 2 3 60 0 255 10\n").colors, colors);
  EXPECT_EQ(parse("1 2 3 1 2 3 255\n1 2 3 0 255 10 255\n").colors, colors); // with an opacity
  EXPECT_TRUE(hasOnlyPoints("1 2 3 50 60 255 255\n1 2 3 60 70 255 255\n"));
  EXPECT_TRUE(hasOnlyPoints("1 2 3 0 0 1 0.7\n1 2 3 0 1 0 9.5\n"));
}

TEST(PointsText, ReadsColorsAheadOfNormals)
{
  const Model model = parse("1 2 3 1 2 3 0 0 1\n1 2 3 0 255 10 0 0 0\n");
  EXPECT_EQ(model.colors, (std::vector<Color>{ { 1, 2, 3 }, { 0, 255, 10 } }));
  EXPECT_EQ(model.normals, (std::vector<Vec3>{ { 0, 0, 1 }, { 0, 0, 0 } }));
  EXPECT_TRUE(hasOnlyPoints("1 2 3 1 2 3 0 0 1\n1 2 3 0 255 10 0 0 3\n"));
  EXPECT_TRUE(hasOnlyPoints("1 2 3 1 2 3 0 0 1\n1 2 3 0 256 10 0 0 1\n"));
}

TEST(PointsText, GuessesNothing)
{
  EXPECT_TRUE(hasOnlyPoints("1 2 3 4\n4 5 6 255\n"));
  EXPECT_TRUE(hasOnlyPoints("1 2 3 4 5\n"));
  EXPECT_TRUE(hasOnlyPoints("1 2 3 0 0 0\n4 5 6 0 0 0\n"));
  EXPECT_TRUE(hasOnlyPoints("1 2 3 0.5 0.5 0.5\n"));
  EXPECT_TRUE(hasOnlyPoints("1 2 3 10 20 30.5\n"));
  EXPECT_TRUE(hasOnlyPoints("1 2 3 10 20 300\n"));
  EXPECT_TRUE(hasOnlyPoints("1 2 3 10 20 -1\n"));
  EXPECT_TRUE(hasOnlyPoints("1 2 3 a b c\n"));
  EXPECT_TRUE(hasOnlyPoints("1 2 3 a 1 2 3 4 5\n"));
  EXPECT_TRUE(hasOnlyPoints("1 2 3 1 2 3 4 5\n"));
  EXPECT_TRUE(hasOnlyPoints("1 2 3 1 2 3 0 0 1 7\n"));
  EXPECT_TRUE(hasOnlyPoints("1,2,3,,,1,,2\n"));
}

TEST(PointsText, MakesPointsWithoutAColorWhite)
{
  constexpr Color kWhite = { 255, 255, 255 };
  std::string text = "1 2 3\n1 2 3 nan 1 2\n1 2 3 4 5\n1 2 3 # 7 8 9\n";
  for (int i = 0; i < 1000; ++i)
  {
    text += "1 2 3 4 5 6\n";
  }
  text += "1 2 3 256 0 0\n1 2 3 4 5.5 6\n1 2 3 4 5\n1 2 3 9 8 7 6\n";
  const std::vector<Color> colors = parse(text).colors;
  ASSERT_EQ(colors.size(), 1008U);
  EXPECT_EQ(std::count(colors.begin(), colors.end(), kWhite), 6);
  EXPECT_EQ(colors[1005], (Color{ 4, 6, 6 }));
  EXPECT_EQ(colors[4], (Color{ 4, 5, 6 }));
  EXPECT_EQ(colors.back(), (Color{ 9, 8, 7 }));
  const Model model = parse("1 2 3 0 0 1\n1 2 3\n1 2 3 nan 0 0\n");
  EXPECT_EQ(model.normals, (std::vector<Vec3>{ { 0, 0, 1 }, { 0, 0, 0 }, { 0, 0, 0 } }));
}

TEST(PointsText, ReadsLetteredLists)
{
  EXPECT_EQ(points("# a\nd 0 0 0\ng 1 0 0\np 1 2.5 -3\ns 1 1 1\np 4 5 6e-3\n"), kTwo);
}

TEST(PointsText, NamesTheLineThatIsNoPoint)
{
  EXPECT_EQ(error("1 2 3\r\n4 5\r\n"),
    "file: line 2: expected x y z, found '4 5'; correct or remove the line");
  EXPECT_NE(error("1 2 3\n4 five 6\n").find("line 2"), std::string::npos);
  EXPECT_NE(error("1 2 3\nnotes\n").find("line 2"), std::string::npos);
  EXPECT_NE(error("1 2 3\n7\n").find("line 2"), std::string::npos);
  EXPECT_NE(error("1,,2,3\n").find("line 1"), std::string::npos);
  EXPECT_NE(error("1 2 3e\n").find("line 1"), std::string::npos);
  EXPECT_NE(error("0x1 2 3\n").find("line 1"), std::string::npos);
  EXPECT_NE(error("1.#INF 2 3\n").find("line 1"), std::string::npos);
}

TEST(PointsText, RefusesDecimalCommasInsteadOfMisreadingThem)
{
  for (const char* const text : { "1,5;2,5;3,5\n", "1,5 2,5 3,5\n", "1,5\t2\t3\n",
         "1;2;3\n1,5;2,5;3,5\n", "1 2 3\n4 5 6\n1 2 3,25\n", "1 2 3\n1 2,5 3\n" })
  {
    EXPECT_NE(error(text).find("decimal commas"), std::string::npos) << text;
  }
  EXPECT_EQ(points("1,5,2\n").size(), 1U);
  EXPECT_EQ(points("1,5,2 0.5\n1, 5, 2;\n1 ,5;2,\n").size(), 3U);
}

TEST(PointsText, RefusesTextWithoutPointsAndUtf16)
{
  EXPECT_NE(error("# nothing\n").find("no point found"), std::string::npos);
  EXPECT_NE(error("solid a\nendsolid a\n").find("no point found"), std::string::npos);
  EXPECT_NE(error(std::string_view("\xff\xfe"
                                   "1\0 \0",
                    6))
              .find("UTF-16"),
    std::string::npos);
}

TEST(PointsText, CountsUnusableCoordinates)
{
  EXPECT_EQ(error("1 2 3\n\nnan 0 0\n4 inf 5\n1 1 1e51\n"),
    "file: 3 of 4 points have coordinates that are not finite or exceed 1e50 (first: line 3); "
    "remove them");
}

TEST(PointsText, IsTheSameForAnyNumberOfThreads)
{
  const std::string text = manyLines(150000, 7); // several chunks
  const scan::TriMesh one = scan::test::parse(scan::parsePointsText, text, 1);
  ASSERT_EQ(one.points.size(), 150000U);
  EXPECT_EQ(one.points, scan::test::parse(scan::parsePointsText, text, 2).points);
}

TEST(PointsText, HasTheSameAttributesForAnyNumberOfThreads)
{
  std::string text;
  for (int i = 0; i < 100000; ++i)
  {
    text += std::to_string(i) + " 2 3 " + std::to_string(i % 256) + " 0 " +
      (i % 7 == 0      ? "\n"
          : i % 2 == 0 ? "9 0 0.6 -0.8\n"
                       : "9 1 0 0\n");
  }
  const Model one = parse(text, 1);
  const Model four = parse(text, 4);
  ASSERT_EQ(one.colors.size(), 100000U);
  ASSERT_EQ(one.normals.size(), 100000U);
  EXPECT_EQ(one.colors[65537], (Color{ 65537 % 256, 0, 9 }));
  EXPECT_EQ(one.colors, four.colors);
  EXPECT_EQ(one.normals, four.normals);
}

TEST(PointsText, NamesALineFarDownTheFile)
{
  std::string text = manyLines(150000, 7);
  text += "broken line\n";
  EXPECT_NE(error(text).find("line 150002"), std::string::npos) << error(text);
}

TEST(PointsText, StopsWhenCancelled)
{
  const std::string text = manyLines(1000, 7);
  scan::CancelToken token;
  token.cancel();
  scan::Execution execution(1, token);
  EXPECT_THROW(scan::parsePointsText(text, "file", execution), scan::Cancelled);
}

TEST(PointsText, ReportsProgress)
{
  const std::string text = manyLines(200000, 7);
  std::size_t reports = 0;
  scan::Execution execution(1, {}, [&](std::string_view, double) { ++reports; });
  execution.plan({ { "read", 1.0 } });
  scan::parsePointsText(text, "file", execution);
  EXPECT_GE(reports, text.size() >> 21U);
}

TEST(PointsText, ReadsTheColumnsThatAHeaderNames)
{
  const std::vector<Color> colors = { { 1, 2, 3 }, { 0, 255, 10 } };
  EXPECT_EQ(parse("//X Y Z R G B Scalar\n1 2 3 1 2 3 50\n1 2 3 0 255 10 60\n").colors, colors);
  EXPECT_EQ(
    parse("x,y,z,intensity,red,green,blue,class\n1,2,3,9,1,2,3,7\n1,2,3,9,0,255,10,7\n").colors,
    colors);
  const Model both = parse("\"X\";\"Y\";\"Z\";\"i\";\"R\";\"G\";\"B\";\"Nx\";\"Ny\";\"Nz\"\n"
                           "1;2;3;9;1;2;3;0;0;1\n1;2;3;9;0;255;10;0;-1;0\n");
  EXPECT_EQ(both.colors, colors);
  EXPECT_EQ(both.normals, (std::vector<Vec3>{ { 0, 0, 1 }, { 0, -1, 0 } }));
  // fractions, a line out of range, normals of any length
  EXPECT_EQ(parse("# X Y Z R G B\n1 2 3 0.5 0.25 1\n1 2 3 0 0 0\n1 2 3 7 0 0\n").colors,
    (std::vector<Color>{ { 128, 64, 255 }, { 0, 0, 0 }, { 255, 255, 255 } }));
  EXPECT_EQ(parse("X Y Z Rf Gf Bf\n1 2 3 0 1 1\n").colors, (std::vector<Color>{ { 0, 255, 255 } }));
  EXPECT_EQ(parse("X Y Z Nx Ny Nz\n1 2 3 0 0 0.5\n").normals, (std::vector<Vec3>{ { 0, 0, 1 } }));
  // names of other columns, and columns that are not what they are named
  EXPECT_TRUE(hasOnlyPoints("# X Y Z a b c\n1 2 3 1 2 3\n1 2 3 0 255 10\n"));
  EXPECT_TRUE(hasOnlyPoints("# X Y Z R G B\n1 2 3 -7 0.25 1\n1 2 3 -8 0 0\n"));
  // the header stands above other lines
  EXPECT_EQ(parse("//X Y Z R G B I\n2\n\n// c\n1 2 3 1 2 3 9\n1 2 3 0 255 10 9\n").colors, colors);
  // a title is no header
  EXPECT_EQ(parse("# a scan of a tooth\n1 2 3 1 2 3\n1 2 3 0 255 10\n").colors, colors);
}

TEST(PointsText, FindsTheCoordinatesThatAHeaderNames)
{
  EXPECT_EQ(points("ID,X,Y,Z\n1,1,2.5,-3\n2,4,5,6e-3\n"), kTwo);
  EXPECT_EQ(points("name;t;x;y;z\na;0.5;1;2.5;-3\n# c\n\nb;0.5;4;5;6e-3\n"), kTwo);
  EXPECT_EQ(error("name;t;x;y;z\na;0.5;1;2.5;-3\nb c;0.5;4;5;6e-3\n"),
    "file: line 3: expected x y z, found 'b c;0.5;4;5;6e-3'; correct or remove the line");
  EXPECT_EQ(parse("id x y z r g b\nP1 1 2.5 -3 1 2 3\nP2 4 5 6e-3 4 5 6\n").colors,
    (std::vector<Color>{ { 1, 2, 3 }, { 4, 5, 6 } }));
  EXPECT_EQ(error("Z,Y,X\n1,2,3\n"),
    "file: line 1: the columns of x, y and z do not follow each other in this order; export them "
    "so");
  // words of a sentence
  EXPECT_EQ(points("# columns are x y z\n1 2.5 -3\n4 5 6e-3\n"), kTwo);
}

TEST(PointsText, LeavesOutPointsThatAreNoNumber)
{
  const Model model =
    parse("1 2.5 -3 1 2 3\nnan nan nan 0 0 0\n4 5 6e-3 0 255 10\n1 NaN 3 7 7 7\n");
  EXPECT_EQ(model.points, kTwo);
  EXPECT_EQ(model.colors, (std::vector<Color>{ { 1, 2, 3 }, { 0, 255, 10 } }));
  EXPECT_EQ(model.note, "points whose coordinates are not a number left out: 2");
  EXPECT_EQ(error("nan nan nan\n"), "file: no point with coordinates; there is nothing to load");
}

TEST(PointsText, EndsAtWhatEndedTextsOnce)
{
  EXPECT_EQ(points("1 2.5 -3\r\n4 5 6e-3\r\n\x1a"), kTwo);
  EXPECT_EQ(points("1 2.5 -3\n4 5 6e-3\n" + std::string(100, '\0')), kTwo);
}

TEST(PointsText, KnowsItsOwn)
{
  const auto looks = [](std::string_view head) {
    return scan::looksLikePointsText({ head.data(), head.size() });
  };
  EXPECT_TRUE(looks("3\n1 2 3\n"));
  EXPECT_TRUE(looks("# c\np 1 2 3\n"));
  EXPECT_FALSE(looks(""));
  EXPECT_FALSE(looks("v 1 2 3\n"));
  EXPECT_FALSE(looks(std::string_view("1 2 3\n\0x", 8)));
}
