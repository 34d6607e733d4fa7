// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/ply.h"

#include "tests/readers/parsing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <limits>

namespace
{

using scan::Color;
using scan::Model;
using scan::Triangle;
using scan::Vec3;

Model parse(std::string_view text)
{
  return scan::test::parse(scan::parsePly, text);
}

std::string error(std::string_view text)
{
  return scan::test::parseError(scan::parsePly, text);
}

const std::string kXyz = "property float x\nproperty float y\nproperty float z\n";
const std::string kAscii = "ply\nformat ascii 1.0\n";
const std::string kSquare = "element vertex 4\n" + kXyz +
  "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
  "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";

template <class T>
void append(std::string& bytes, T value, bool isBig)
{
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  if (isBig)
  {
    std::reverse(raw, raw + sizeof(T));
  }
  bytes.append(raw, sizeof(T));
}

/// Lists and scalars of many types around what counts.
std::string binaryFile(bool isBig)
{
  std::string bytes = std::string("ply\nformat binary_") + (isBig ? "big" : "little") +
    "_endian 1.0\nobj_info is_mesh 0\nelement camera 1\nproperty list ushort short view\n"
    "property char on\nelement vertex 3\nproperty uchar red\nproperty double x\n"
    "property list uint8 float32 extra\nproperty float y\nproperty int16 z\n"
    "element face 2\nproperty list uchar uint vertex_index\nproperty float quality\n"
    "element range_grid 2\nproperty list uchar int vertex_indices\nend_header\n";
  append<std::uint16_t>(bytes, 2, isBig);
  append<std::int16_t>(bytes, -1, isBig);
  append<std::int16_t>(bytes, 7, isBig);
  append<std::int8_t>(bytes, 1, isBig);
  for (int i = 0; i < 3; ++i)
  {
    append<std::uint8_t>(bytes, 200, isBig);
    append<double>(bytes, i + 0.1, isBig);
    append<std::uint8_t>(bytes, static_cast<std::uint8_t>(i), isBig);
    for (int k = 0; k < i; ++k)
    {
      append<float>(bytes, 9.0F, isBig);
    }
    append<float>(bytes, static_cast<float>(i) - 0.5F, isBig);
    append<std::int16_t>(bytes, static_cast<std::int16_t>(-300 * i), isBig);
  }
  for (int i = 0; i < 2; ++i)
  {
    append<std::uint8_t>(bytes, 3, isBig);
    for (std::uint32_t k = 0; k < 3; ++k)
    {
      append<std::uint32_t>(bytes, i == 0 ? k : 2 - k, isBig);
    }
    append<float>(bytes, 1.0F, isBig);
  }
  append<std::uint8_t>(bytes, 0, isBig);
  append<std::uint8_t>(bytes, 1, isBig);
  append<std::int32_t>(bytes, 2, isBig);
  return bytes;
}

} // namespace

TEST(Ply, ReadsBothByteOrdersAndSkipsTheRest)
{
  for (const bool isBig : { false, true })
  {
    const Model mesh = parse(binaryFile(isBig));
    const std::vector<Vec3> points = { { 0.1, -0.5, 0 }, { 1.1, 0.5, -300 }, { 2.1, 1.5, -600 } };
    EXPECT_EQ(mesh.points, points);
    const std::vector<Triangle> triangles = { { 0, 1, 2 }, { 2, 1, 0 } };
    EXPECT_EQ(mesh.triangles, triangles);
    EXPECT_TRUE(mesh.colors.empty()); // of red alone
  }
}

TEST(Ply, ReadsColorsAndNormalsOfBothByteOrders)
{
  for (const bool isBig : { false, true })
  {
    std::string bytes = std::string("ply\nformat binary_") + (isBig ? "big" : "little") +
      "_endian 1.0\nelement vertex 2\nproperty double nx\nproperty uchar blue\n" + kXyz +
      "property float ny\nproperty uchar alpha\nproperty uchar red\nproperty int nz\n"
      "property uchar green\nend_header\n";
    for (const int i : { 0, 1 })
    {
      append<double>(bytes, 3.0 * i, isBig);
      append<std::uint8_t>(bytes, static_cast<std::uint8_t>(30 + i), isBig);
      for (const int axis : { 1, 2, 3 })
      {
        append<float>(bytes, static_cast<float>(axis + i), isBig);
      }
      append<float>(bytes, 0.0F, isBig);
      append<std::uint8_t>(bytes, 99, isBig);
      append<std::uint8_t>(bytes, static_cast<std::uint8_t>(10 + i), isBig);
      append<std::int32_t>(bytes, -4 * i, isBig);
      append<std::uint8_t>(bytes, static_cast<std::uint8_t>(200 + i), isBig);
    }
    const Model model = parse(bytes);
    EXPECT_EQ(model.points, (std::vector<Vec3>{ { 1, 2, 3 }, { 2, 3, 4 } }));
    EXPECT_EQ(model.colors, (std::vector<Color>{ { 10, 200, 30 }, { 11, 201, 31 } }));
    EXPECT_EQ(model.normals, (std::vector<Vec3>{ { 0, 0, 0 }, { 0.6, 0, -0.8 } }));
    EXPECT_NE(error(bytes.substr(0, bytes.size() - 1)).find("truncated"), std::string::npos);
  }
}

TEST(Ply, ReadsColorsOfEveryRange)
{
  const auto colors = [](const std::string& type, const std::string& prefix, std::string_view first,
                        std::string_view second)
  {
    std::string text = kAscii + "element vertex 2\n" + kXyz;
    for (const char* const name : { "red", "green", "blue" })
    {
      text.append("property ").append(type).append(" ").append(prefix).append(name).append("\n");
    }
    text.append("end_header\n1 2 3 ").append(first).append("\n1 2 3 ").append(second);
    return parse(text).colors;
  };
  using Colors = std::vector<Color>;
  EXPECT_EQ(
    colors("uchar", "diffuse_", "1 0 1", "0 255 9"), (Colors{ { 1, 0, 1 }, { 0, 255, 9 } }));
  EXPECT_EQ(colors("uchar", "", "1 0 1", "0 1 0"), (Colors{ { 1, 0, 1 }, { 0, 1, 0 } }));
  EXPECT_EQ(
    colors("float", "", "1 0 1", "0 0.5 0.502"), (Colors{ { 255, 0, 255 }, { 0, 128, 128 } }));
  EXPECT_EQ(colors("double", "", "1 0 1", "0 255 9.4"), (Colors{ { 1, 0, 1 }, { 0, 255, 9 } }));
  EXPECT_EQ(colors("float", "", "nan 0 1", "0 1 0"), (Colors{ { 255, 255, 255 }, { 0, 255, 0 } }));
  EXPECT_EQ(
    colors("int", "", "-1 0 1", "0 256 0"), (Colors{ { 255, 255, 255 }, { 255, 255, 255 } }));
  EXPECT_TRUE(colors("float", "", "nan 0 1", "0 -1 0").empty());
}

TEST(Ply, TurnsPolygonsIntoFans)
{
  const std::vector<Triangle> fan = { { 0, 1, 2 }, { 0, 2, 3 } };
  EXPECT_EQ(parse(kAscii + kSquare + "4 0 1 2 3\n").triangles, fan);
}

TEST(Ply, FillsConcavePolygonsInsideTheirBorder)
{
  const std::string text = kAscii + "element vertex 4\n" + kXyz +
    "element face 1\nproperty list int int vertex_indices\nend_header\n"
    "0 0 0\n4 2 0\n1 2 0\n0 4 0\n4 1 2 3 0\n";
  EXPECT_DOUBLE_EQ(scan::test::areaOf(parse(text)), 5.0);
}

TEST(Ply, FillsPolygonsAheadOfTheirVertices)
{
  const std::string text = kAscii +
    "element face 2\nproperty list int int vertex_indices\nelement vertex 4\n" + kXyz +
    "end_header\n4 1 2 3 0\n3 0 1 2\n0 0 0\n4 2 0\n1 2 0\n0 4 0\n";
  EXPECT_DOUBLE_EQ(scan::test::areaOf(parse(text)), 5.0 + 3.0);
}

TEST(Ply, ReadsColorsOf16Bits)
{
  const auto colors = [](const std::string& first, const std::string& second)
  {
    return parse(kAscii + "element vertex 2\n" + kXyz +
      "property ushort red\nproperty ushort green\nproperty ushort blue\nend_header\n0 0 0 " +
      first + "\n1 1 1 " + second + "\n")
      .colors;
  };
  EXPECT_EQ(
    colors("65535 0 300", "256 255 32768"), (std::vector<Color>{ { 255, 0, 1 }, { 1, 0, 128 } }));
  EXPECT_EQ(colors("255 0 7", "1 2 3"), (std::vector<Color>{ { 255, 0, 7 }, { 1, 2, 3 } }));
}

TEST(Ply, TakesAChannelSlightlyAboveOneForOne)
{
  const std::string text = kAscii + "element vertex 1\n" + kXyz +
    "property float red\nproperty float green\nproperty float blue\nend_header\n0 0 0 0 0.5 "
    "1.0001\n";
  EXPECT_EQ(parse(text).colors, (std::vector<Color>{ { 0, 128, 255 } }));
}

TEST(Ply, ReadsHeadersBehindAByteOrderMark)
{
  const std::string text =
    "\xef\xbb\xbfply \r\n" + kAscii.substr(4) + "element vertex 1\n" + kXyz + "end_header\n1 2 3\n";
  EXPECT_TRUE(scan::looksLikePly(text));
  EXPECT_EQ(parse(text).points, (std::vector<scan::Vec3>{ { 1, 2, 3 } }));
}

TEST(Ply, NamesTheIndexThatIsNoInteger)
{
  EXPECT_NE(error(kAscii + kSquare + "3 0 1 1.5\n").find("expected an integer, found '1.5'"),
    std::string::npos);
}

TEST(Ply, LeavesOutFacesWithoutArea)
{
  EXPECT_TRUE(parse(kAscii + kSquare + "2 0 1\n").triangles.empty());
  EXPECT_TRUE(parse(kAscii + kSquare + "0\n").triangles.empty());
}

TEST(Ply, UnrollsStrips)
{
  const std::string text = kAscii + "element vertex 5\n" + kXyz +
    "element tristrips 1\nproperty list int int vertex_indices\nend_header\n"
    "0 0 0\n1 0 0\n0 1 0\n1 1 0\n2 2 2\n8 0 1 2 3 -1 2 3 4\n";
  const std::vector<Triangle> triangles = { { 0, 1, 2 }, { 2, 1, 3 }, { 2, 3, 4 } };
  EXPECT_EQ(parse(text).triangles, triangles);
}

TEST(Ply, AcceptsCarriageReturns)
{
  std::string text = kAscii + kSquare + "4 0 1 2 3\n";
  const Model expected = parse(text);
  std::replace(text.begin(), text.end(), '\n', '\r');
  EXPECT_EQ(parse(text).points, expected.points);
  for (std::size_t at = 0; (at = text.find('\r', at)) != text.npos; at += 2)
  {
    text.insert(at + 1, 1, '\n');
  }
  EXPECT_EQ(parse(text).triangles, expected.triangles);
}

TEST(Ply, JoinsARangeGridWhenAsked)
{
  const std::string size = "obj_info num_cols 3\nobj_info num_rows 3\n";
  const std::string rest = "element vertex 8\n" + kXyz +
    "element range_grid 9\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0\n1 0 0\n2 0 0\n0 1 0\n1 1 0\n2 1 0\n0 2 0\n1 2 0\n"
    "1 0\n1 1\n1 2\n1 3\n2 4 0\n1 5\n1 6\n1 7\n0\n";
  const auto join = [](const std::string& text)
  { return scan::test::parse(scan::parsePlyRangeGrid, text); };
  const std::vector<Triangle> triangles = { { 0, 1, 4 }, { 0, 4, 3 }, { 1, 2, 5 }, { 1, 5, 4 },
    { 3, 4, 7 }, { 3, 7, 6 } };
  EXPECT_EQ(join(kAscii + size + rest).triangles, triangles);
  EXPECT_TRUE(parse(kAscii + size + rest).triangles.empty());
  EXPECT_EQ(parse(kAscii + size + rest).points.size(), 8U);
  for (const std::string wrong : { "", "obj_info num_cols 3\nobj_info num_rows 4\n",
         "obj_info num_cols 0\n", "obj_info num_cols x\nobj_info num_rows 3\n" })
  {
    const std::string message =
      scan::test::parseError(scan::parsePlyRangeGrid, kAscii + wrong + rest);
    EXPECT_NE(message.find("the range_grid has 9 cells"), std::string::npos) << message;
  }
  EXPECT_EQ(join(kAscii + kSquare + "4 0 1 2 3\n").triangles.size(), 2U);
}

TEST(Ply, RefusesIndicesWithoutAVertex)
{
  EXPECT_EQ(error(kAscii + kSquare + "3 0 1 4\n"),
    "file: line 14: a face refers to vertex 4, but there are 4, counted from 0");
  EXPECT_NE(error(kAscii + kSquare + "3 0 1 -1\n").find("vertex -1"), std::string::npos);
  EXPECT_NE(error(kAscii + kSquare + "3 0 1 1.5\n").find("integer"), std::string::npos);
}

TEST(Ply, RefusesIndicesWithoutAVertexInBinaryFacesToo)
{
  for (const std::int32_t corner : { 3, -1, std::numeric_limits<std::int32_t>::min() })
  {
    std::string bytes = "ply\nformat binary_little_endian 1.0\nelement vertex 3\n" + kXyz +
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
    bytes.append(36, '\0');
    bytes += '\3';
    for (const std::int32_t value : { 0, 1, corner })
    {
      append<std::int32_t>(bytes, value, false);
    }
    const std::string what = "a face refers to vertex " + std::to_string(corner) + ", but there";
    EXPECT_NE(error(bytes).find(what), std::string::npos) << error(bytes);
  }
}

TEST(Ply, BoundsEveryCountByTheFile)
{
  const std::string huge = "element vertex 4000000000\n" + kXyz + "end_header\n0 0 0\n";
  EXPECT_NE(error(kAscii + huge).find("truncated"), std::string::npos);
  EXPECT_NE(
    error("ply\nformat binary_little_endian 1.0\n" + huge).find("truncated"), std::string::npos);
  EXPECT_NE(error(kAscii + kSquare + "4000000000 0 1 2\n").find("does not fit"), std::string::npos);
  EXPECT_NE(error(kAscii + kSquare + "3 0 1").find("line 14"), std::string::npos);
}

TEST(Ply, BoundsAllCountsTogetherByTheFile)
{
  const std::string binary = "ply\nformat binary_little_endian 1.0\n";
  const std::string bytes = "property uchar x\nproperty uchar y\nproperty uchar z\n";
  const std::string list = "property list uint uchar vertex_indices\nend_header\n";
  const std::string data(120, '\0');
  const auto message = [&](const std::string& vertices, const std::string& faces)
  {
    return error(binary + "element vertex " + vertices + "\n" + bytes + "element face " + faces +
      "\n" + list + data);
  };
  EXPECT_EQ(message("20", "15"), "");
  EXPECT_NE(message("20", "16").find("announces 16 of 'face', more"), std::string::npos);
  EXPECT_NE(message("41", "0").find("announces 41 of 'vertex', more"), std::string::npos);
  EXPECT_NE(message("40", "9223372036854775808").find("of 'face', more"), std::string::npos);
}

TEST(Ply, MakesNoRoomForMoreTrianglesThanTheFileCanHold)
{
  std::string bytes = "ply\nformat binary_little_endian 1.0\nelement vertex 3\n" + kXyz +
    "element face 1\nproperty list ushort uchar vertex_indices\nend_header\n" +
    std::string(36, '\0') + "\x88\x13" + std::string(5000, '\0');
  const Model mesh = parse(bytes);
  EXPECT_EQ(mesh.triangles.size(), 4998U);
  EXPECT_LE(mesh.triangles.capacity(), 5000U);
}

TEST(Ply, RefusesASecondListOfPoints)
{
  const std::string twice = "element vertex 1\n" + kXyz + "element vertex 1\n" + kXyz;
  EXPECT_EQ(error(kAscii + twice + "end_header\n0 0 0\n1 1 1\n"),
    "file: line 7: a second element 'vertex'; only one list of points can be read");
}

TEST(Ply, CountsUnusableCoordinates)
{
  const std::string text = kAscii + "element vertex 2\n" + kXyz + "end_header\n1 2 3\n1 -inf 3\n";
  EXPECT_EQ(error(text),
    "file: 1 of 2 points have coordinates that are not finite or exceed 1e50 (first: line 8); "
    "remove them");
}

TEST(Ply, ExplainsAMalformedHeader)
{
  EXPECT_NE(error("plx\n").find("line 1"), std::string::npos);
  EXPECT_NE(error("ply\nformat ascii 1.0\n").find("end_header"), std::string::npos);
  EXPECT_NE(error(kAscii + "element vertex many\n").find("line 3: the element count 'many'"),
    std::string::npos);
  EXPECT_NE(error(kAscii + "element vertex 1\nproperty half x\nend_header\n")
              .find("line 4: unknown property type 'half'"),
    std::string::npos);
  EXPECT_NE(error(kAscii + "element vertex 1\nproperty float x\nend_header\n1\n").find("x, y, z"),
    std::string::npos);
}
