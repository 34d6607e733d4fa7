// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/pts.h"

#include "readers/mapped_file.h"
#include "readers/points_text.h"
#include "tests/readers/damage.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace
{

using scan::Color;
using scan::Model;
using scan::Vec3;

Model parse(std::string_view text)
{
  return scan::test::parse(scan::parsePts, text);
}

void expectError(std::string_view text, const std::string& part)
{
  const std::string message = scan::test::parseError(scan::parsePts, text);
  EXPECT_NE(message.find(part), std::string::npos) << text << "\n" << message;
}

/// Scans of many points, with colours in every second one.
std::string manyScans(std::size_t scans, std::size_t points)
{
  std::string text;
  for (std::size_t s = 0; s < scans; ++s)
  {
    text += std::to_string(points) + "\n";
    for (std::size_t i = 0; i < points; ++i)
    {
      text += std::to_string(s) + "." + std::to_string(i) + " -1.5 " + std::to_string(i) + " -317" +
        (s % 2 == 0 ? " 1 2 " + std::to_string(i % 256) + "\n" : "\r\n");
    }
  }
  return text;
}

const std::vector<Vec3> kTwo = { { 1.0, 2.5, -3.0 }, { 4.0, 5.0, 6e-3 } };

} // namespace

TEST(Pts, ReadsPointsAndColors)
{
  const Model model = parse("2\n1 2.5 -3 -1024 255 0 7\n4 5 6e-3 0.5 0 128 255\n");
  EXPECT_EQ(model.points, kTwo);
  EXPECT_EQ(model.colors, (std::vector<Color>{ { 255, 0, 7 }, { 0, 128, 255 } }));
  EXPECT_TRUE(model.triangles.empty());
  EXPECT_TRUE(model.normals.empty());
  EXPECT_EQ(model.millimetresPerUnit, 0.0);
}

TEST(Pts, ReadsEveryLayout)
{
  const std::vector<Color> colors = { { 255, 0, 7 }, { 0, 128, 255 } };
  EXPECT_EQ(parse("2\n1 2.5 -3 7\n4 5 6e-3 8\n").points, kTwo);
  EXPECT_TRUE(parse("2\n1 2.5 -3 7\n4 5 6e-3 8\n").colors.empty());
  EXPECT_EQ(parse("2\n1 2.5 -3\n4 5 6e-3\n").points, kTwo);
  EXPECT_EQ(parse("2\n1 2.5 -3 255 0 7\n4 5 6e-3 0 128 255\n").colors, colors);
  EXPECT_EQ(parse("2\n1 2.5 -3 1 255 0 7 0 0 1\n4 5 6e-3 1 0 128 255 0 0 x\n").colors, colors);
}

TEST(Pts, AcceptsBlankLinesAndEveryLineEnd)
{
  EXPECT_EQ(parse("\xef\xbb\xbf 2 \r\n\r\n  1\t2.5  -3 7 \r\n \r\n4 5 6e-3 8").points, kTwo);
  EXPECT_EQ(parse("2\r1 2.5 -3 7\r4 5 6e-3 8\r").points, kTwo);
}

TEST(Pts, PutsSeveralScansTogether)
{
  const Model model = parse("1\n1 2.5 -3 9\n\n0\n1\n4 5 6e-3 9\n");
  EXPECT_EQ(model.points, kTwo);
  const Model mixed = parse("1\n1 2.5 -3 9\n1\n4 5 6e-3 9 1 2 3\n1\n0 0 0 1\n");
  EXPECT_EQ(mixed.points.size(), 3U);
  EXPECT_EQ(
    mixed.colors, (std::vector<Color>{ { 255, 255, 255 }, { 1, 2, 3 }, { 255, 255, 255 } }));
}

TEST(Pts, ReadsSeveralScansOfCoordinates)
{
  EXPECT_EQ(parse("1\n1 2.5 -3\n# the next one\n1\n4 5 6e-3\n").points, kTwo);
}

TEST(Pts, ReliesOnNoCount)
{
  EXPECT_EQ(parse("1\n1 2.5 -3 9\n4 5 6e-3 9\n").points, kTwo);
  EXPECT_EQ(parse("4000000000\n1 2.5 -3 9\n4 5 6e-3 9\n").points, kTwo);
  EXPECT_EQ(parse("3\n1 2.5 -3 9\n4 5 6e-3 9\n").note,
    "the file announces 3 points, but has 2; it may be truncated");
  EXPECT_EQ(parse("1\n1 2.5 -3 9\n4 5 6e-3 9\n").note, "");
}

TEST(Pts, NamesTheMalformedLine)
{
  expectError("1 2 3 4\n", "line 1: expected the number of points, found '1 2 3 4'");
  expectError("1.5\n1 2 3 4\n", "line 1: expected the number of points");
  expectError("-1\n1 2 3 4\n", "line 1: expected the number of points");
  expectError("2\n1 2 3 4\n1 2 3\n", "line 3: expected numbers in the columns");
  expectError("2\n1 2 3 4 5\n1 2 3 4 5\n", "line 2: expected x y z, perhaps an intensity");
  expectError("2\n1 2 3 4 5 6 7\n1 2 3 4\n", "line 3: expected numbers in the columns");
  expectError("2\n1 2 3 4 5 6 7\n1 2 3 4 5 6 256\n", "colours from 0 to 255");
  expectError("2\n1 2 3 4 5 6 7\n1 2 3 4 5 6 -1\n", "line 3");
  expectError("2\n1 2 3 4\n1 2 3 x\n", "found '1 2 3 x'; correct or remove the line");
  expectError("2\n1 2 3 4\n}\n", "line 3");
  expectError("1\n1 2 3 4\nnan\n", "line 3: expected the number of points");
  expectError("", "line 1: expected the number of points");
  expectError("0\n", "no point found");
  expectError(std::string_view("\xff\xfe\x31\0", 4), "UTF-16");
}

TEST(Pts, CountsUnusableCoordinates)
{
  expectError("3\n1 2 3 4\n\nnan 0 0 1\n0 1e60 0 1\n", "2 of 3 points");
  expectError("3\n1 2 3 4\n\nnan 0 0 1\n0 1e60 0 1\n", "first: line 4");
}

TEST(Pts, IsTheSameForAnyNumberOfThreads)
{
  const std::string text = manyScans(3, 60000); // several chunks a scan
  const Model one = scan::test::parse(scan::parsePts, text, 1);
  const Model four = scan::test::parse(scan::parsePts, text, 4);
  ASSERT_EQ(one.points.size(), 180000U);
  EXPECT_EQ(one.points[60001], (Vec3{ 1.1, -1.5, 1.0 }));
  EXPECT_EQ(one.colors[59999], (Color{ 1, 2, 59999 % 256 }));
  EXPECT_EQ(one.colors[60000], scan::Color({ 255, 255, 255 }));
  EXPECT_EQ(one.points, four.points);
  EXPECT_EQ(one.colors, four.colors);
  expectError(text + "1 2 3 4 5 x 7\n", "line 180004");
}

TEST(Pts, ReadsManySmallScans)
{
  EXPECT_EQ(parse(manyScans(50000, 2)).points.size(), 100000U);
}

TEST(Pts, EndsInErrorOrModelWhenDamaged)
{
  scan::test::expectErrorOrModelWhenDamaged(scan::parsePts, manyScans(4, 100));
  scan::test::expectErrorOrModelWhenDamaged(scan::parsePts, manyScans(3, 2));
}

TEST(Pts, StopsWhenCancelled)
{
  scan::CancelToken token;
  token.cancel();
  scan::Execution execution(1, token);
  EXPECT_THROW(scan::parsePts(manyScans(1, 9), "file", execution), scan::Cancelled);
}

TEST(Pts, KnowsItsOwn)
{
  const auto looks = [](std::string_view head) {
    return scan::looksLikePts({ head.data(), head.size() });
  };
  EXPECT_TRUE(looks("2\n1 2 3 4\n"));
  EXPECT_TRUE(looks("2\r\n\r\n1 2 3 4 5 6 7\r\n"));
  EXPECT_TRUE(looks("2\n1 2 3\n4 5 6\n1\n1 2 3"));
  EXPECT_TRUE(looks("# c\n2\n1 2 3 0 0 1\n// c\n4 5 6 1 1 0\n"));
  EXPECT_FALSE(looks("2\n1 2 3 0 0 1\n4 5 6 0 1 0\n")); // normals
  EXPECT_FALSE(looks("2\n1 2 3 0.6 0 0.8\n"));
  EXPECT_FALSE(looks("//X Y Z R G B Intensity\n2\n1 2 3 4 5 6 7\n4 5 6 7 8 9 10\n"));
  EXPECT_FALSE(looks("2\n1 2 3 1 0.5 6 7\n"));
  EXPECT_FALSE(looks("2\n1 2 3\n1 2 3 4\n"));
  EXPECT_FALSE(looks("1 2 3 4\n"));     // no count
  EXPECT_FALSE(looks("2\n3\n1 2 3\n")); // PTX
  EXPECT_FALSE(looks("2\n1 2 3 x\n"));
  EXPECT_FALSE(looks(""));
}

TEST(Pts, ReadsVertexListsAsTheirReader)
{
  const std::string folder = SCAN_SHARED_DIR "/data/";
  if (!std::filesystem::exists(folder))
  {
    GTEST_SKIP() << folder << " is missing";
  }
  for (const char* const file : { "01_points/cgal/bunny_ran.pts", "01_points/cgal/thom1249.pts",
         "01_points/cgal/torus_ran.pts", "01_points/hoppe/curve1.pts", "07_contours/skull.pts" })
  {
    const scan::MappedFile mapped(folder + file);
    scan::Execution execution;
    if (scan::looksLikePts(mapped.bytes()))
    {
      EXPECT_EQ(scan::parsePts(mapped.bytes(), file, execution).points,
        scan::parsePointsText(mapped.bytes(), file, execution).points);
    }
  }
}
