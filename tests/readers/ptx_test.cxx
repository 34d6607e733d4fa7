// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/ptx.h"

#include "tests/readers/damage.h"

#include <gtest/gtest.h>

namespace
{

using scan::Color;
using scan::Model;
using scan::Vec3;

Model parse(std::string_view text)
{
  return scan::test::parse(scan::parsePtx, text);
}

void expectError(std::string_view text, const std::string& part)
{
  const std::string message = scan::test::parseError(scan::parsePtx, text);
  EXPECT_NE(message.find(part), std::string::npos) << text << "\n" << message;
}

const std::string kPose = "10 20 30\n0 1 0\n-1 0 0\n0 0 1\n";
/// A quarter turn about z that takes x to y, then a move by 10 20 30.
const std::string kMatrix = "0 1 0 0\n-1 0 0 0\n0 0 1 0\n10 20 30 1\n";

std::string header(std::size_t columns, std::size_t rows)
{
  return std::to_string(columns) + "\n" + std::to_string(rows) + "\n" + kPose + kMatrix;
}

/// Every third cell is void; every second scan has colours.
std::string manyScans(std::size_t scans, std::size_t columns, std::size_t rows)
{
  std::string text;
  for (std::size_t s = 0; s < scans; ++s)
  {
    text += header(columns, rows);
    for (std::size_t i = 0; i < columns * rows; ++i)
    {
      const std::string point =
        i % 3 == 2 ? "0 0 0 0.5" : std::to_string(i + 1) + " 2 " + std::to_string(s) + " 0.25";
      text += point + (s % 2 == 0 ? "\n" : " 10 20 30\r\n");
    }
  }
  return text;
}

} // namespace

TEST(Ptx, MovesPointsByTheMatrixAndLeavesVoidsOut)
{
  const Model model =
    parse(header(2, 2) + "1 0 0 0.5\n0 0 0 0.5\n0 1 0.5 0.25\n0.000000 0 -0.0 0\n");
  EXPECT_EQ(model.points, (std::vector<Vec3>{ { 10, 21, 30 }, { 9, 20, 30.5 } }));
  EXPECT_TRUE(model.colors.empty());
  EXPECT_TRUE(model.triangles.empty());
  EXPECT_EQ(model.millimetresPerUnit, 1000.0);
}

TEST(Ptx, KeepsThePrecisionOfGeoreferencedScans)
{
  const Model model = parse("1\n1\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n"
                            "513450.125 5402650.0625 248.41 1\n0.001 0.002 0.003 0.5\n");
  ASSERT_EQ(model.points.size(), 1U);
  EXPECT_EQ(model.points[0], (Vec3{ 513450.125 + 0.001, 5402650.0625 + 0.002, 248.41 + 0.003 }));
}

TEST(Ptx, ReadsColors)
{
  const Model model = parse(header(1, 3) + "1 0 0 0.5 1 2 3\n0 0 0 0.5 9 9 9\n0 1 0 0.5 255 0 4\n");
  EXPECT_EQ(model.colors, (std::vector<Color>{ { 1, 2, 3 }, { 255, 0, 4 } }));
}

TEST(Ptx, PutsSeveralScansTogether)
{
  const Model model = parse(manyScans(3, 2, 2));
  ASSERT_EQ(model.points.size(), 9U);
  EXPECT_EQ(model.points[0], (Vec3{ 8, 21, 30 }));
  EXPECT_EQ(model.points[2], (Vec3{ 8, 24, 30 }));
  EXPECT_EQ(model.points[3], (Vec3{ 8, 21, 31 }));
  EXPECT_EQ(model.points[8], (Vec3{ 8, 24, 32 }));
  ASSERT_EQ(model.colors.size(), 9U);
  EXPECT_EQ(model.colors[0], (Color{ 255, 255, 255 }));
  EXPECT_EQ(model.colors[5], (Color{ 10, 20, 30 }));
  EXPECT_EQ(parse(header(0, 5) + manyScans(1, 1, 2)).points.size(), 2U);
}

TEST(Ptx, RefusesScansOfOtherSizesThanAnnounced)
{
  expectError(header(2, 2) + "1 0 0 1\n1 0 0 1\n1 0 0 1\n",
    "line 1: the scan announces 4 cells, but 3 lines follow");
  expectError(header(1, 1) + "1 0 0 1\n1 0 0 1\n", "announces 1 cells, but 2 lines follow");
  expectError(manyScans(1, 1, 1) + manyScans(1, 1, 1) + header(1, 2) + "1 0 0 1\n",
    "line 23: the scan announces 2 cells, but 1 lines");
  expectError(header(100000, 100000) + "1 0 0 1\n", "line 1: the scan announces 10000000000 cells");
  expectError(header(4294967295, 4294967295) + "1 0 0 1\n", "more than the file can hold");
}

TEST(Ptx, NamesTheMalformedLine)
{
  expectError("", "line 1: expected the number of columns");
  expectError("1.5\n1\n", "line 1: expected the number of columns, found '1.5'");
  expectError("1\n1 1\n", "line 2: expected the number of rows");
  expectError("1\n1\n0 0\n", "line 3: expected 3 numbers, the place");
  expectError("1\n1\n" + kPose + "1 0 0 0\n0 1 0\n", "line 8: expected 4 numbers, a row");
  expectError("1\n1\n" + kPose + "1 0 0 10\n0 1 0 20\n0 0 1 30\n0 0 0 1\n1 1 1 1\n",
    "line 7: the last column of the matrix must be 0 0 0 1");
  expectError(header(1, 2) + "1 0 0 1\n1 0 x 1\n", "line 12: expected numbers in the columns");
  expectError(header(1, 2) + "1 0 0 1 0 0 0\n1 0 0 1 0 0 300\n", "line 12");
  expectError(header(1, 2) + "0 0 0 0\n0 0 0 0\n", "no point found");
}

TEST(Ptx, CountsUnusableCoordinates)
{
  expectError(header(1, 3) + "1 0 0 1\nnan 0 0 1\n1e60 0 0 1\n", "2 of 3 points");
  expectError("1\n1\n" + kPose + "1e40 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n1e40 1 1 1\n",
    "1 of 1 points have coordinates that are not finite or exceed 1e50 (first: line 11)");
}

TEST(Ptx, IsTheSameForAnyNumberOfThreads)
{
  const std::string text = manyScans(2, 300, 200);
  const Model one = scan::test::parse(scan::parsePtx, text, 1);
  const Model three = scan::test::parse(scan::parsePtx, text, 3);
  EXPECT_EQ(one.points.size(), 80000U);
  EXPECT_EQ(one.points, three.points);
  EXPECT_EQ(one.colors, three.colors);
}

TEST(Ptx, ReadsManySmallScans)
{
  EXPECT_EQ(parse(manyScans(20000, 1, 2)).points.size(), 40000U);
}

TEST(Ptx, EndsInErrorOrModelWhenDamaged)
{
  scan::test::expectErrorOrModelWhenDamaged(scan::parsePtx, manyScans(3, 10, 9));
  scan::test::expectErrorOrModelWhenDamaged(scan::parsePtx, manyScans(2, 1, 2));
}

TEST(Ptx, StopsWhenCancelled)
{
  scan::CancelToken token;
  token.cancel();
  scan::Execution execution(1, token);
  EXPECT_THROW(scan::parsePtx(manyScans(1, 3, 3), "file", execution), scan::Cancelled);
}

TEST(Ptx, KnowsItsOwn)
{
  const auto looks = [](std::string_view head) {
    return scan::looksLikePtx({ head.data(), head.size() });
  };
  EXPECT_TRUE(looks(header(2, 2)));
  EXPECT_TRUE(
    looks("2\r\n2\r\n0 0 0\r\n1 0 0\r\n0 1 0\r\n0 0 1\r\n1 0 0 0\r\n0 1 0 0\r\n0 0 1 0\r\n"
          "0 0 0 1\r\n"));
  EXPECT_FALSE(looks("2\n2\n0 0 0\n1 1 1\n2 2 2\n3 3 3\n4 4 4\n5 5 5\n6 6 6\n7 7 7\n"));
  EXPECT_FALSE(looks("2\n1 2 3 4\n"));
  EXPECT_FALSE(looks("2\n2\n1 2 3 4\n"));
  EXPECT_FALSE(looks("1 2 3\n"));
  EXPECT_FALSE(looks(""));
}
