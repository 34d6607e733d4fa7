// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/obj.h"

#include "tests/readers/parsing.h"

#include <gtest/gtest.h>

namespace
{

using scan::Color;
using scan::Model;
using scan::Triangle;
using scan::Vec3;

Model parse(std::string_view text)
{
  return scan::test::parse(scan::parseObj, text);
}

std::string error(std::string_view text)
{
  return scan::test::parseError(scan::parseObj, text);
}

const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
const std::vector<Triangle> kFan = { { 0, 1, 2 }, { 0, 2, 3 } };

} // namespace

TEST(Obj, AcceptsEveryFormOfCorner)
{
  EXPECT_EQ(parse(kSquare + "f 1 2 3 4\n").triangles, kFan);
  EXPECT_EQ(parse(kSquare + "f 1/7 2/7 3/7 4/7\n").triangles, kFan);
  EXPECT_EQ(parse(kSquare + "f 1//1 2//1 3//-1 4//1\n").triangles, kFan);
  EXPECT_EQ(parse(kSquare + "f 1/2/3 2/2/3 3/-2/-3 4/2/ # quad\n").triangles, kFan);
  EXPECT_EQ(parse(kSquare + "f -4 -3 -2 -1").triangles, kFan);
}

TEST(Obj, AcceptsFacesAheadOfTheirVertices)
{
  EXPECT_EQ(parse("f 1 2 3 4\n" + kSquare).triangles, kFan);
}

TEST(Obj, FillsConcavePolygonsInsideTheirBorder)
{
  EXPECT_DOUBLE_EQ(
    scan::test::areaOf(parse("v 0 0 0\nv 4 2 0\nv 1 2 0\nv 0 4 0\nf 2 3 4 1\n")), 5.0);
}

TEST(Obj, FillsPolygonsAheadOfTheirVertices)
{
  EXPECT_DOUBLE_EQ(
    scan::test::areaOf(parse("f 2 3 4 1\nv 0 0 0\nv 4 2 0\nv 1 2 0\nv 0 4 0\n")), 5.0);
}

TEST(Obj, SkipsAWeightAheadOfAColour)
{
  EXPECT_EQ(parse("v 1 2 3 1 10 20 30\n").colors, (std::vector<scan::Color>{ { 10, 20, 30 } }));
}

TEST(Obj, LeavesOutPointsThatAreNoNumberWithTheirColours)
{
  const Model model = parse("v 0 0 0 1 2 3\nv nan 0 0 4 5 6\nv 1 1 1 7 8 9\n\x1a");
  EXPECT_EQ(model.points.size(), 2U);
  EXPECT_EQ(model.colors, (std::vector<scan::Color>{ { 1, 2, 3 }, { 7, 8, 9 } }));
}

TEST(Obj, JoinsContinuedLines)
{
  EXPECT_EQ(parse(kSquare + "f 1 2 \\\n 3 4\n").triangles, kFan);
  EXPECT_EQ(parse(kSquare + "f 1 2 3\\\r\n4\r\n").triangles, kFan);
  EXPECT_EQ(parse("v 0 \\\n 1 2 \\\n 0.5 0.5 0.5\n").points, (std::vector<Vec3>{ { 0, 1, 2 } }));
  EXPECT_EQ(parse("# C:\\models\\\nv 0 1 2\n").points.size(), 1U);
}

TEST(Obj, ReadsLinesAsCurves)
{
  const Model model = parse(kSquare + "l 1 2 3\nvn 0 0 1\nl 1/1 -1\nl 4\nl 1 2 \\\n 1 # closed\n");
  EXPECT_EQ(model.curves.corners, (std::vector<scan::Index>{ 0, 1, 2, 0, 3, 0, 1, 0 }));
  EXPECT_EQ(model.curves.ends, (std::vector<std::size_t>{ 3, 5, 8 }));
  EXPECT_TRUE(model.triangles.empty());
  EXPECT_EQ(error(kSquare + "l 1 5\n"),
    "file: line 5: a face or line refers to vertex 5, but there are 4, counted from 1");
}

TEST(Obj, KeepsNormalsOfFacesBesideLines)
{
  const std::string normals = "vn 0 0 1\nvn 0 0 1\nvn 0 0 1\nvn 0 0 1\n";
  EXPECT_EQ(parse(kSquare + normals + "f 1//1 2//2 3//3 4//4\nl 1 2\n").normals.size(), 4U);
}

TEST(Obj, ReadsAScanOfVerticesOnly)
{
  const Model mesh = parse("# scan\r\nvn 0 0 1\r\nv 1 2 3 0.5 0.5 nan\r\np 1\r\nl 1\r\n");
  EXPECT_EQ(mesh.points, (std::vector<Vec3>{ { 1, 2, 3 } }));
  EXPECT_TRUE(mesh.triangles.empty());
  EXPECT_TRUE(mesh.colors.empty());
}

TEST(Obj, ReadsColorsOfEitherRange)
{
  using Colors = std::vector<Color>;
  EXPECT_EQ(parse("v 0 0 0 1 0.5 0\nv 1 0 0 0 .004 1e0 # b\n").colors,
    (Colors{ { 255, 128, 0 }, { 0, 1, 255 } }));
  EXPECT_EQ(parse("v 0 0 0 1 0 0\r\nv 1 0 0 2 128 255\r\n").colors,
    (Colors{ { 1, 0, 0 }, { 2, 128, 255 } }));
  // a weight, a comment and what is out of range are no colours
  EXPECT_EQ(
    parse("v 0 0 0\nv 0 0 0 1\nv 0 0 0 # 1 1 1\nv 0 0 0 1 0 \\\n0\nv 0 0 0 -1 0 0\n").colors,
    (Colors{
      { 255, 255, 255 }, { 255, 255, 255 }, { 255, 255, 255 }, { 255, 0, 0 }, { 255, 255, 255 } }));
  EXPECT_TRUE(parse("v 0 0 0 1\nv 0 0 0 red green blue\n").colors.empty());
}

TEST(Obj, KeepsNormalsOfPoints)
{
  const std::string normals = "vn 0 0 2\nvn 0 3 4\nvn 1 0 0\nvn 0 0 0\n";
  const std::vector<Vec3> expected = { { 0, 0, 1 }, { 0, 0.6, 0.8 }, { 1, 0, 0 }, { 0, 0, 0 } };
  EXPECT_EQ(parse(kSquare + normals + "f 1//1 2//2 3//3 4//4\n").normals, expected);
  EXPECT_EQ(parse("f 1//1 2//2 3//3 4//4\n" + kSquare + normals).normals, expected);
  EXPECT_EQ(parse(kSquare + normals + "f 1/9/1 2/8/2 -2//-2 -1/7/-1\n").normals, expected);
  EXPECT_EQ(parse(normals + kSquare).normals, expected);
  // fewer normals than points, for those of the faces
  EXPECT_EQ(parse(kSquare + "vn 0 0 1\nvn 0 0 1\nvn 0 0 1\nf 1//1 2//2 3//3\n").normals,
    (std::vector<Vec3>{ { 0, 0, 1 }, { 0, 0, 1 }, { 0, 0, 1 }, { 0, 0, 0 } }));
}

TEST(Obj, LeavesOutNormalsOfCorners)
{
  const std::string normals = "vn 0 0 1\nvn 0 1 0\nvn 1 0 0\nvn 0 1 1\n";
  for (const std::string faces : { "f 1//1 2//2 3//4\n", "f 1//1 2//2 3\n", "f 1//1 2/2 3//3\n",
         "f 1/1/1 2//2 3//3/3\nf 1 2 3\n", "f 1//1 2//2 3//3\nvn 0 0 x\n" })
  {
    const Model model = parse(kSquare + normals + faces);
    EXPECT_TRUE(model.normals.empty()) << faces;
    EXPECT_FALSE(model.triangles.empty());
  }
  EXPECT_TRUE(parse(kSquare + "vn 0 0 1\nf 1//1 2//2 3//3\n").normals.empty());
  EXPECT_TRUE(parse(kSquare + "vn 0 0 1\n").normals.empty()); // a scan
  EXPECT_TRUE(parse(normals + kSquare + "f 1 2 3\n").normals.empty());
}

TEST(Obj, NamesTheLineOfAMissingVertex)
{
  EXPECT_EQ(error(kSquare + "f 1 2 3\nf 1 2 5\n"),
    "file: line 6: a face or line refers to vertex 5, but there are 4, counted from 1");
  EXPECT_NE(error(kSquare + "f 0 1 2\n").find("line 5"), std::string::npos);
  EXPECT_NE(error(kSquare + "f -5 1 2\n").find("line 5"), std::string::npos);
}

TEST(Obj, NamesTheMalformedLine)
{
  EXPECT_NE(error(kSquare + "f 1 2 x\n").find("line 5: expected a corner"), std::string::npos);
  EXPECT_NE(error(kSquare + "f 1 2 3-4\n").find("line 5"), std::string::npos);
  EXPECT_NE(error(kSquare + "f\n").find("line 5: a face without corners"), std::string::npos);
  EXPECT_NE(error("v 1 2\nv 1 2 3\n").find("line 1"), std::string::npos);
  EXPECT_NE(error("v 1 2 3.1+e2\n").find("line 1"), std::string::npos);
  EXPECT_NE(error("# empty\n").find("no vertex"), std::string::npos);
}

TEST(Obj, CountsUnusableCoordinates)
{
  EXPECT_NE(error("v 0 0 0\nv inf 0 0\nv 1e60 0 0\n").find("2 of 3 points"), std::string::npos);
}

TEST(Obj, IsRecognisedBehindAByteOrderMark)
{
  const auto looks = [](std::string_view head) {
    return scan::looksLikeObj({ head.data(), head.size() });
  };
  EXPECT_TRUE(looks("\xef\xbb\xbfv 1 2 3\n"));
  EXPECT_TRUE(looks("\xef\xbb\xbf# by hand\nv 1 2 3\n"));
  EXPECT_FALSE(looks("\xef\xbb\xbf"));
}
