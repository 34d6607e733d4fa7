// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/points_text.h"

#include "tests/readers/parsing.h"

#include <gtest/gtest.h>

#include <random>

namespace
{

using scan::Vec3;

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
  for (const char* const text : { "1,5;2,5;3,5\n", "1,5 2,5 3,5\n", "1,5\t2\t3\n" })
  {
    EXPECT_NE(error(text).find("decimal commas"), std::string::npos) << text;
  }
  EXPECT_EQ(points("1,5,2\n").size(), 1U);
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

TEST(PointsText, KnowsItsOwn)
{
  const auto looks = [](std::string_view head) {
    return scan::looksLikePointsText({ head.data(), head.size() });
  };
  EXPECT_TRUE(looks("3\n1 2 3\n"));
  EXPECT_TRUE(looks("# c\np 1 2 3\n"));
  EXPECT_FALSE(looks(""));
  EXPECT_FALSE(looks("v 1 2 3\n"));
  EXPECT_FALSE(looks(std::string_view("1 2 3\n\0", 7)));
}
