// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/pcd.h"

#include "readers/mapped_file.h"
#include "tests/readers/damage.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <limits>

namespace
{

using scan::Color;
using scan::Model;
using scan::Vec3;

Model parse(std::string_view bytes)
{
  return scan::test::parse(scan::parsePcd, bytes);
}

void expectError(std::string_view bytes, const std::string& part)
{
  const std::string message = scan::test::parseError(scan::parsePcd, bytes);
  EXPECT_NE(message.find(part), std::string::npos) << bytes.substr(0, 300) << "\n" << message;
}

template <class T>
std::string raw(T value)
{
  return { reinterpret_cast<const char*>(&value), sizeof(T) };
}

std::string header(const std::string& fields, const std::string& sizes, const std::string& types,
  std::size_t points, const std::string& data)
{
  const std::string count = std::to_string(points);
  return "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS " + fields + "\nSIZE " +
    sizes + "\nTYPE " + types + "\nWIDTH " + count +
    "\nHEIGHT 1\nVIEWPOINT 1 2 3 1 0 0 0\nPOINTS " + count + "\nDATA " + data + "\n";
}

std::string plain(std::size_t points, const std::string& data)
{
  return header("x y z", "4 4 4", "F F F", points, data);
}

/// An LZF stream of literals, with every run of equal bytes as a reference.
std::string compress(const std::string& bytes)
{
  std::string result;
  for (std::size_t at = 0; at < bytes.size();)
  {
    std::size_t run = 1;
    while (run < 200 && at + run < bytes.size() && bytes[at + run] == bytes[at])
    {
      ++run;
    }
    result += '\0';
    result += bytes[at++];
    if (run >= 10) // the rest of the run is a copy of the byte before: length - 2 in 7 + a byte
    {
      result += '\xe0';
      result += static_cast<char>(run - 1 - 9);
      result += '\0';
      at += run - 1;
    }
    else if (run >= 4)
    {
      result += static_cast<char>((run - 1 - 2) << 5U);
      result += '\0';
      at += run - 1;
    }
  }
  return raw(static_cast<std::uint32_t>(result.size())) +
    raw(static_cast<std::uint32_t>(bytes.size())) + result;
}

const float kNan = std::numeric_limits<float>::quiet_NaN();
const std::vector<Vec3> kTwo = { { 1.0, 2.5, -3.0 }, { 4.0, 5.0, 6.25 } };

std::string manyRecords(std::size_t count)
{
  std::string body;
  for (std::size_t i = 0; i < count; ++i)
  {
    const auto t = static_cast<float>(i);
    body += raw(i % 5 == 4 ? kNan : t) + raw(-0.5F * t) + raw(2.0F) + raw(0.0F) + raw(2.0F) +
      raw(0.0F) + raw(static_cast<std::uint32_t>(i * 77));
  }
  return body;
}

std::string manyHeader(std::size_t count, const std::string& data)
{
  return header(
    "x y z normal_x normal_y normal_z rgb", "4 4 4 4 4 4 4", "F F F F F F U", count, data);
}

} // namespace

TEST(Pcd, ReadsText)
{
  const Model model = parse(plain(2, "ascii") + "1 2.5 -3\r\n\n 4\t5 6.25");
  EXPECT_EQ(model.points, kTwo);
  EXPECT_TRUE(model.colors.empty());
  EXPECT_TRUE(model.normals.empty());
  EXPECT_EQ(model.millimetresPerUnit, 0.0);
}

TEST(Pcd, ReadsBinaryRecords)
{
  const Model model = parse(plain(2, "binary") + raw(1.0F) + raw(2.5F) + raw(-3.0F) + raw(4.0F) +
    raw(5.0F) + raw(6.25F) + "padding");
  EXPECT_EQ(model.points, kTwo);
}

TEST(Pcd, ReadsEveryTypeInAnyOrder)
{
  const std::string head = header("a y b x c z", "1 2 8 8 1 1", "U I F F I I", 1, "binary");
  EXPECT_EQ(parse(head + raw(std::uint8_t(9)) + raw(std::int16_t(-300)) + raw(7.0) + raw(1.1) +
              raw(std::int8_t(-9)) + raw(std::int8_t(-3)))
              .points,
    (std::vector<Vec3>{ { 1.1, -300, -3 } }));
  const std::string wide = header("z y x", "8 4 4", "U U I", 1, "binary");
  EXPECT_EQ(
    parse(wide + raw(std::uint64_t(1) << 40U) + raw(0xffffffffU) + raw(std::int32_t(-7))).points,
    (std::vector<Vec3>{ { -7, 4294967295.0, 1099511627776.0 } }));
}

TEST(Pcd, AcceptsHeaderLinesInAnyOrderAndOldOnes)
{
  EXPECT_EQ(parse("TYPE F F F U\nCOUNT 1 1 1 4\nPOINTS 2\nSIZE 4 4 4 1\nFIELDS x y z _\n"
                  "DATA ascii\n1 2.5 -3 0 0 128 63\n4 5 6.25 nan - x 1\n")
              .points,
    kTwo);
  EXPECT_EQ(
    parse("# .PCD v.5\nCOLUMNS x y z\nPOINTS 2\nDATA ascii\n1 2.5 -3\n4 5 6.25\n").points, kTwo);
  EXPECT_EQ(
    parse("FIELDS x y z\nWIDTH 1\nHEIGHT 2\nDATA ascii\n1 2.5 -3\n4 5 6.25\n").points, kTwo);
}

TEST(Pcd, LeavesPointsThatAreNoNumbersOut)
{
  EXPECT_EQ(parse(plain(4, "ascii") + "1 2.5 -3\nnan nan nan\n4 5 6.25\n1 1 NaN\n").points, kTwo);
  expectError(plain(1, "ascii") + "nan nan nan\n", "no point with coordinates");
}

TEST(Pcd, ReadsColorsPackedInIntegersAndFloats)
{
  const std::vector<Color> expected = { { 255, 128, 7 } };
  const std::uint32_t packed = 0xff8007U;
  const std::uint32_t opaque = 0xffff8007U; // as a float it is no number
  for (const char* const type : { "F", "U", "I" })
  {
    const std::string head =
      header("rgb x y z", "4 4 4 4", std::string(type) + " F F F", 1, "binary");
    for (const std::uint32_t value : { packed, opaque })
    {
      EXPECT_EQ(parse(head + raw(value) + raw(1.0F) + raw(2.0F) + raw(3.0F)).colors, expected);
    }
  }
  const std::string text = header("x y z rgba", "4 4 4 4", "F F F U", 1, "ascii");
  EXPECT_EQ(parse(text + "1 2 3 " + std::to_string(opaque)).colors, expected);
  const std::string real = header("x y z rgb", "4 4 4 4", "F F F F", 1, "ascii");
  char bits[64];
  std::snprintf(bits, sizeof(bits), "%.9g", static_cast<double>(std::bit_cast<float>(packed)));
  EXPECT_EQ(parse(real + "1 2 3 " + bits).colors, expected);
  EXPECT_EQ(parse(real + "1 2 3 4.2108e+06").colors, (std::vector<Color>{ { 64, 64, 112 } }));
}

TEST(Pcd, ReadsNormalsAtLengthOne)
{
  const std::string head =
    header("normal_z x y z normal_x normal_y", "4 4 4 4 4 4", "F F F F F F", 3, "ascii");
  EXPECT_EQ(parse(head + "2 1 1 1 0 0\n0 1 1 1 0 -3\nnan 1 1 1 nan nan\n").normals,
    (std::vector<Vec3>{ { 0, 0, 1 }, { 0, -1, 0 }, {} }));
}

TEST(Pcd, ReadsCompressedDataAsTheSameBinary)
{
  const std::size_t count = 500;
  const std::string records = manyRecords(count);
  std::string columns; // all of the first field, then all of the second
  for (std::size_t field = 0; field < 7; ++field)
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      columns += records.substr(i * 28 + field * 4, 4);
    }
  }
  const Model binary = parse(manyHeader(count, "binary") + records);
  const Model compressed = parse(manyHeader(count, "binary_compressed") + compress(columns));
  ASSERT_EQ(binary.points.size(), 400U);
  EXPECT_EQ(binary.points[1], (Vec3{ 1, -0.5, 2 }));
  EXPECT_EQ(binary.normals[399], (Vec3{ 0, 1, 0 }));
  EXPECT_EQ(binary.colors[399], (Color{ 0, 498 * 77 / 256, 498 * 77 % 256 }));
  EXPECT_EQ(compressed.points, binary.points);
  EXPECT_EQ(compressed.normals, binary.normals);
  EXPECT_EQ(compressed.colors, binary.colors);
}

TEST(Pcd, RefusesBodiesThatDoNotHoldThePoints)
{
  expectError(plain(3, "ascii") + "1 2.5 -3\n4 5 6.25\n", "3 points, but the file holds at most 2");
  expectError(plain(1, "ascii") + "1 2.5 -3\n4 5 6.25\n", "line 12: more lines follow than the 1");
  expectError(plain(999999999, "ascii") + "1 2 3\n", "the header announces 999999999 points");
  expectError(plain(2, "binary") + raw(1.0F) + raw(2.5F) + raw(-3.0F) + raw(4.0F),
    "2 points, but the file holds at most 1; it is truncated");
  expectError(plain(4000000000, "binary") + raw(1.0F), "at most 0");
  expectError(plain(1, "binary_compressed") + "abc", "truncated");
  const std::string body(12, '\0');
  expectError(plain(1, "binary_compressed") + compress(body).substr(0, 10), "cut off");
  expectError(plain(2, "binary_compressed") + compress(body), "does not match the header");
  expectError(plain(1, "binary_compressed") + raw(3U) + raw(12U) + "\x1f\1\2", "are malformed");
  expectError(plain(1, "binary_compressed") + raw(2U) + raw(12U) + "\x20\x01", "are malformed");
  expectError(plain(1, "binary_compressed") + raw(1U) + raw(12U) + "\xe0", "are malformed");
}

TEST(Pcd, RefusesDataThatExpandWithoutBounds)
{
  const std::string bomb = compress(std::string(36000000, '\0'));
  scan::Execution execution(1);
  const std::string bytes = plain(3000000, "binary_compressed") + bomb;
  try
  {
    scan::parsePcd(bytes, "file", execution);
    FAIL() << "accepted";
  }
  catch (const scan::Error& error)
  {
    EXPECT_EQ(error.code(), scan::ErrorCode::limit);
    EXPECT_NE(std::string(error.what()).find("save it as binary"), std::string::npos);
  }
}

TEST(Pcd, NamesWhatIsWrongInTheHeader)
{
  expectError("FIELDS x y\nPOINTS 1\nDATA ascii\n1 2\n", "lacks one of the fields x, y, z");
  expectError("FIELDS x y z\nPOINTS 1\n", "ends without a line DATA");
  expectError("FIELDS x y z\nDATA ascii\n1 2 3\n", "lacks the number of points");
  expectError(
    "FIELDS x y z\nPOINTS -1\nDATA ascii\n", "line 2: expected a whole number, found '-1'");
  expectError("FIELDS x y z\nPOINTS 1\nDATA xml\n", "line 3: expected the data ascii, binary");
  expectError("FIELDS x y z\nWIDTH 2\nPOINTS 1\nDATA ascii\n", "another product");
  expectError("FIELDS x y z\nSIZE 4 4\nPOINTS 1\nDATA ascii\n", "one SIZE, TYPE and COUNT");
  expectError("FIELDS x y z\nPOINTS 1\nDATA binary\n", "lacks SIZE or TYPE");
  expectError(header("x y z", "4 4 3", "F F F", 1, "binary"), "the field 'z' has an unknown type");
  expectError(header("x y z", "4 4 4", "F F Q", 1, "binary"), "the field 'z' has an unknown type");
  expectError("ply\n", "line 1: expected a line of a PCD header, found 'ply'");
  expectError(
    "FIELDS x y z a\nCOUNT 1 1 1 99999999999\nPOINTS 1\nDATA ascii\n", "too many numbers");
}

TEST(Pcd, NamesTheMalformedLine)
{
  expectError(plain(2, "ascii") + "1 2 3\n4 5\n6 7 8\n", "line 12: expected 3 numbers");
  expectError(
    plain(1, "ascii") + "1 2 3x\n", "line 11: expected 3 numbers for a point, found '3x'");
  expectError(plain(2, "ascii") + "1 2 3\n4 1e60 inf\n", "1 of 2 points");
  const float inf = std::numeric_limits<float>::infinity();
  expectError(plain(1, "binary") + raw(inf) + raw(1.0F) + raw(1.0F), "1 of 1 points");
}

TEST(Pcd, EndsInErrorOrModelWhenDamaged)
{
  scan::test::expectErrorOrModelWhenDamaged(
    scan::parsePcd, manyHeader(60, "binary") + manyRecords(60));
  scan::test::expectErrorOrModelWhenDamaged(
    scan::parsePcd, manyHeader(20, "binary_compressed") + compress(manyRecords(20)));
  scan::test::expectErrorOrModelWhenDamaged(
    scan::parsePcd, manyHeader(2, "ascii") + "1 2 3 0 0 1 65280\n1 nan 3 0 0 1 255\n");
}

TEST(Pcd, StopsWhenCancelled)
{
  scan::CancelToken token;
  token.cancel();
  for (const std::string& bytes :
    { plain(1, "ascii") + "1 2 3\n", plain(1, "binary") + std::string(12, '\0'),
      plain(1, "binary_compressed") + compress(std::string(12, '\0')) })
  {
    scan::Execution execution(1, token);
    EXPECT_THROW(scan::parsePcd(bytes, "file", execution), scan::Cancelled);
  }
}

TEST(Pcd, KnowsItsOwn)
{
  const auto looks = [](std::string_view head) {
    return scan::looksLikePcd({ head.data(), head.size() });
  };
  EXPECT_TRUE(looks(plain(1, "ascii")));
  EXPECT_TRUE(looks("VERSION .7\nFIELDS x y z\n"));
  EXPECT_TRUE(looks("# made by hand\nFIELDS x y z\n"));
  EXPECT_TRUE(looks("COLUMNS x y z\nDATA ascii\n"));
  EXPECT_FALSE(looks("# a list\n1 2 3\n"));
  EXPECT_FALSE(looks("ply\n"));
  EXPECT_FALSE(looks(""));
}

TEST(Pcd, ReadsRealFiles)
{
  const std::string folder = SCAN_SHARED_DIR "/data/";
  if (!std::filesystem::exists(folder))
  {
    GTEST_SKIP() << folder << " is missing";
  }
  struct Row
  {
    const char* file;
    std::size_t points;
    Vec3 smallest;
    Vec3 largest;
  };
  const Row rows[] = {
    { "03_large/pcl_terrain/CSite2_orig-utm.pcd", 486800, { 513450, 5.40265e6, 248.41 },
      { 513870, 5.40328e6, 482.63 } },
    { "03_large/pcl_terrain/CSite4_orig-utm.pcd", 518056, { 513120, 5.40319e6, 188.31 },
      { 513630, 5.40376e6, 356.24 } },
    { "04_point_formats/pcd/capture0001.pcd", 307200 - 57553, { -1.72282, -1.19528, 1.512 },
      { 1.22344, 0.780963, 3.157 } },
    { "04_point_formats/pcd/capture0002.pcd", 307200 - 57269, { -1.69226, -1.18963, 1.539 },
      { 1.26434, 0.7693, 3.101 } },
    { "04_point_formats/pcd/object_template_0.pcd", 1397, { -0.1914, 0.0182667, 0.691 },
      { -0.02384, 0.18775, 0.791 } },
    { "04_point_formats/pcd/rops_points.pcd", 32087, { -0.41984, -0.24034, -1.4022 },
      { 0.40617, 0.24871, -1.0098 } },
  };
  for (const Row& row : rows)
  {
    const scan::MappedFile mapped(folder + row.file);
    EXPECT_TRUE(scan::looksLikePcd(mapped.bytes().first(200))) << row.file;
    scan::Execution execution;
    const Model model = scan::parsePcd(mapped.bytes(), mapped.name(), execution);
    EXPECT_EQ(model.points.size(), row.points) << row.file;
    Vec3 smallest = model.points.front();
    Vec3 largest = smallest;
    for (const Vec3& p : model.points)
    {
      smallest = { std::min(smallest.x, p.x), std::min(smallest.y, p.y),
        std::min(smallest.z, p.z) };
      largest = { std::max(largest.x, p.x), std::max(largest.y, p.y), std::max(largest.z, p.z) };
    }
    const auto expectNear = [&](const Vec3& a, const Vec3& b)
    {
      const Vec3 d = a - b;
      EXPECT_LE(std::sqrt(dot(d, d)), 2e-6 * std::sqrt(dot(b, b))) << row.file;
    };
    expectNear(smallest, row.smallest);
    expectNear(largest, row.largest);
  }
}
