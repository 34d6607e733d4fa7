// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/las.h"

#include "readers/mapped_file.h"
#include "readers/points_text.h"
#include "tests/readers/damage.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <limits>

namespace
{

using scan::Color;
using scan::Model;
using scan::Vec3;

const std::string kFolder = SCAN_SHARED_DIR "/data/";

template <class T>
void put(std::string& bytes, std::size_t at, T value)
{
  std::memcpy(bytes.data() + at, &value, sizeof(T));
}

struct Layout
{
  std::size_t size;
  std::size_t color; // 0: none
};

/// Of the point formats, from the tables of the specification.
constexpr Layout kLayouts[] = { { 20, 0 }, { 28, 0 }, { 26, 20 }, { 34, 28 }, { 57, 0 }, { 63, 28 },
  { 30, 0 }, { 36, 30 }, { 38, 30 }, { 59, 0 }, { 67, 30 } };

/// A file with points at (i, -2 i, 3), scale .5 .25 1e-3, offset 100 200 5402650.125.
struct Las
{
  int minor = 2;
  std::uint8_t format = 0;
  std::size_t points = 3;
  std::size_t extra = 0;   // bytes behind the known ones of a record
  unsigned brightness = 1; // of the colours
  std::string records;     // variable length
  std::uint32_t recordCount = 0;

  std::size_t headerSize() const { return this->minor == 4 ? 375 : this->minor == 3 ? 235 : 227; }
  std::size_t recordSize() const
  {
    return (this->format < 11 ? kLayouts[this->format].size : 12) + this->extra;
  }
  std::size_t start() const { return this->headerSize() + this->records.size(); }

  void addRecord(std::uint16_t id, const std::string& data)
  {
    std::string head(54, '\0');
    head.replace(2, 15, "LASF_Projection");
    put(head, 18, id);
    put(head, 20, static_cast<std::uint16_t>(data.size()));
    this->records += head + data;
    ++this->recordCount;
  }

  std::string bytes() const
  {
    std::string result(this->headerSize(), '\0');
    result.replace(0, 4, "LASF");
    put(result, 24, std::uint8_t(1));
    put(result, 25, static_cast<std::uint8_t>(this->minor));
    put(result, 94, static_cast<std::uint16_t>(this->headerSize()));
    put(result, 96, static_cast<std::uint32_t>(this->start()));
    put(result, 100, this->recordCount);
    put(result, 104, this->format);
    put(result, 105, static_cast<std::uint16_t>(this->recordSize()));
    put(result, 107, this->format < 6 ? static_cast<std::uint32_t>(this->points) : 0U);
    const double numbers[] = { 0.5, 0.25, 1e-3, 100.0, 200.0, 5402650.125 };
    std::memcpy(result.data() + 131, numbers, sizeof(numbers));
    if (this->minor == 4)
    {
      put(result, 247, static_cast<std::uint64_t>(this->points));
    }
    result += this->records;
    for (std::size_t i = 0; i < this->points; ++i)
    {
      std::string record(this->recordSize(), '\0');
      const auto t = static_cast<std::int32_t>(i);
      put(record, 0, t);
      put(record, 4, -2 * t);
      put(record, 8, 3);
      if (this->format < 11 && kLayouts[this->format].color != 0)
      {
        const std::size_t red = kLayouts[this->format].color;
        put(record, red, static_cast<std::uint16_t>(this->brightness * (i + 1)));
        put(record, red + 2, static_cast<std::uint16_t>(this->brightness * 20));
        put(record, red + 4, static_cast<std::uint16_t>(this->brightness * 255));
      }
      result += record;
    }
    return result;
  }
};

/// A GeoTIFF directory with one key, ProjLinearUnits: 9001, the metre.
const std::string kMetreKeys("\1\0\1\0\0\0\1\0\4\x0c\0\0\1\0\x29\x23", 16);

const std::vector<Vec3> kPoints = { { 100, 200, 5402650.125 + 0.003 },
  { 100.5, 199.5, 5402650.125 + 0.003 }, { 101, 199, 5402650.125 + 0.003 } };

Model parse(const std::string& bytes)
{
  return scan::test::parse(scan::parseLas, bytes);
}

void expectError(const std::string& bytes, const std::string& part)
{
  const std::string message = scan::test::parseError(scan::parseLas, bytes);
  EXPECT_NE(message.find(part), std::string::npos) << message;
}

template <class T>
std::string changed(std::string bytes, std::size_t at, T value)
{
  put(bytes, at, value);
  return bytes;
}

Model load(const std::string& file)
{
  const scan::MappedFile mapped(kFolder + file);
  EXPECT_TRUE(scan::looksLikeLas(mapped.bytes())) << file;
  scan::Execution execution;
  return scan::parseLas(mapped.bytes(), mapped.name(), execution);
}

} // namespace

TEST(Las, ReadsEveryVersionAndFormat)
{
  for (const int minor : { 0, 1, 2, 3, 4 })
  {
    for (std::uint8_t format = 0; format < (minor == 4 ? 12 : 6); ++format)
    {
      for (const std::size_t extra : { 0U, 5U })
      {
        Las las;
        las.minor = minor;
        las.format = format;
        las.extra = extra;
        const Model model = parse(las.bytes());
        EXPECT_EQ(model.points, kPoints) << minor << " " << int(format) << " " << extra;
        const bool hasColors = format < 11 && kLayouts[format].color != 0;
        const std::vector<Color> colors = { { 1, 20, 255 }, { 2, 20, 255 }, { 3, 20, 255 } };
        EXPECT_EQ(model.colors, hasColors ? colors : std::vector<Color>{})
          << minor << " " << int(format);
        EXPECT_TRUE(model.triangles.empty());
        EXPECT_TRUE(model.normals.empty());
        EXPECT_EQ(model.millimetresPerUnit, 0.0);
      }
    }
  }
}

TEST(Las, ReadsColorsOfSixteenAndOfEightBits)
{
  Las las;
  las.format = 3;
  const std::vector<Color> expected = { { 1, 20, 255 }, { 2, 20, 255 }, { 3, 20, 255 } };
  EXPECT_EQ(parse(las.bytes()).colors, expected);
  las.brightness = 256;
  EXPECT_EQ(parse(las.bytes()).colors, expected);
  las.brightness = 257; // 0 to 65535
  EXPECT_EQ(parse(las.bytes()).colors, expected);
  las.brightness = 0;
  EXPECT_TRUE(parse(las.bytes()).colors.empty());
}

TEST(Las, LeavesWithheldPointsOut)
{
  Las las;
  las.format = 2;
  const std::vector<Vec3> rest = { kPoints[0], kPoints[2] };
  const std::size_t second = las.start() + las.recordSize() + 15;
  const Model model = parse(changed(las.bytes(), second, std::uint8_t(0x82)));
  EXPECT_EQ(model.points, rest);
  EXPECT_EQ(model.note, "withheld points left out: 1");
  EXPECT_EQ(model.colors, (std::vector<Color>{ { 1, 20, 255 }, { 3, 20, 255 } }));
  EXPECT_EQ(parse(changed(las.bytes(), second, std::uint8_t(0x04))).points, kPoints);
  las.minor = 0; // the whole byte is a class
  EXPECT_EQ(parse(changed(las.bytes(), second, std::uint8_t(0x82))).points, kPoints);
  las.minor = 4;
  las.format = 7;
  const std::size_t extended = las.start() + las.recordSize() + 15;
  EXPECT_EQ(parse(changed(las.bytes(), extended, std::uint8_t(0x04))).points, rest);
  EXPECT_EQ(parse(changed(las.bytes(), extended, std::uint8_t(0x8b))).points, kPoints);
  las.points = 1;
  expectError(changed(las.bytes(), las.start() + 15, std::uint8_t(0x04)), "are withheld");
}

TEST(Las, ReadsTheUnitOfTheCoordinateSystem)
{
  Las keys;
  keys.addRecord(1, "other");
  keys.addRecord(34735, kMetreKeys);
  EXPECT_EQ(parse(keys.bytes()).points, kPoints);
  EXPECT_EQ(parse(keys.bytes()).millimetresPerUnit, 1000.0);
  Las text;
  text.addRecord(2112, "PROJCS[\"a\",UNIT[\"foot\",0.3048]]");
  EXPECT_EQ(parse(text.bytes()).millimetresPerUnit, 304.8);
}

TEST(Las, SurvivesBadVariableLengthRecords)
{
  Las las;
  las.addRecord(34735, kMetreKeys);
  const std::string bytes = las.bytes();
  for (const std::uint32_t count : { 0U, 2U, 0xffffffffU })
  {
    EXPECT_EQ(parse(changed(bytes, 100, count)).points, kPoints) << count;
  }
  const Model model = parse(changed(bytes, 227 + 20, std::uint16_t(65535)));
  EXPECT_EQ(model.points, kPoints);
  EXPECT_EQ(model.millimetresPerUnit, 0.0);
}

TEST(Las, RefusesCompressedFilesAndSaysWhatToDo)
{
  Las las;
  for (const unsigned mark : { 0x80U, 0x40U, 0xc0U })
  {
    expectError(
      changed(las.bytes(), 104, static_cast<std::uint8_t>(mark | 3U)), "compressed (LAZ)");
  }
}

TEST(Las, RefusesImpossibleHeaders)
{
  Las las;
  const std::string bytes = las.bytes();
  expectError("", "no LAS file");
  expectError("LASX" + bytes.substr(4), "no LAS file");
  expectError(bytes.substr(0, 100), "ends in the header");
  expectError(changed(bytes, 25, std::uint8_t(5)), "byte 24: version 1.5 of LAS");
  expectError(changed(bytes, 24, std::uint8_t(2)), "version 2.2 of LAS");
  expectError(changed(bytes, 94, std::uint16_t(100)), "byte 94: the header's size");
  expectError(changed(bytes, 96, 100U), "byte 94");
  expectError(changed(bytes, 96, 1000000U), "byte 94");
  expectError(
    changed(bytes, 105, std::uint16_t(19)), "byte 105: records of 19 bytes are too short");
  expectError(changed(bytes, 105, std::uint16_t(0)), "byte 105");
  expectError(changed(bytes, 131, 0.0), "byte 131: the scale");
  expectError(changed(bytes, 139, std::numeric_limits<double>::infinity()), "byte 131");
  expectError(changed(bytes, 171, std::numeric_limits<double>::quiet_NaN()), "byte 131");
}

TEST(Las, RefusesCountsThatLie)
{
  Las las;
  const std::string bytes = las.bytes();
  expectError(changed(bytes, 107, 4U), "announces 4 points, but the file holds 3; it is truncated");
  expectError(changed(bytes, 107, 0xffffffffU), "announces 4294967295 points");
  expectError(bytes.substr(0, bytes.size() - 1), "announces 3 points, but the file holds 2");
  expectError(changed(bytes, 107, 0U), "has no points");
  las.minor = 4;
  las.format = 6;
  expectError(changed(las.bytes(), 247, ~std::uint64_t(0)), "announces 18446744073709551615");
}

TEST(Las, CountsUnusableCoordinates)
{
  Las las;
  expectError(changed(las.bytes(), 131, 1e300), "2 of 3 points");
}

TEST(Las, EndsInErrorOrModelWhenDamaged)
{
  for (const int minor : { 2, 4 })
  {
    Las las;
    las.minor = minor;
    las.format = minor == 4 ? 7 : 3;
    las.points = 40;
    las.addRecord(34735, kMetreKeys);
    las.addRecord(2112, "PROJCS[\"a\",UNIT[\"metre\",1]]");
    scan::test::expectErrorOrModelWhenDamaged(scan::parseLas, las.bytes());
  }
}

TEST(Las, StopsWhenCancelled)
{
  scan::CancelToken token;
  token.cancel();
  scan::Execution execution(1, token);
  EXPECT_THROW(scan::parseLas(Las().bytes(), "file", execution), scan::Cancelled);
}

TEST(Las, ReportsProgress)
{
  Las las;
  las.format = 2;
  las.points = 200000;
  double last = 0.0;
  std::size_t reports = 0;
  scan::Execution execution(1, {},
    [&](std::string_view, double fraction)
    {
      EXPECT_GE(fraction, last);
      last = fraction;
      ++reports;
    });
  execution.plan({ { "read", 1.0 } });
  scan::parseLas(las.bytes(), "file", execution);
  EXPECT_GE(reports, 6U);
}

TEST(Las, ReadsRealFiles)
{
  if (!std::filesystem::exists(kFolder))
  {
    GTEST_SKIP() << kFolder << " is missing";
  }
  const Model colored = load("04_point_formats/las/1.2-with-color.las");
  ASSERT_EQ(colored.points.size(), 1065U);
  EXPECT_EQ(colored.colors.size(), 1065U);
  const auto byZ = [](const Vec3& a, const Vec3& b) { return a.z < b.z; };
  const auto [low, high] = std::minmax_element(colored.points.begin(), colored.points.end(), byZ);
  EXPECT_NEAR(low->z, 406.59, 1e-9);
  EXPECT_NEAR(high->z, 586.38, 1e-9);
  EXPECT_EQ(load("09_bad/pdal/bad_vlr_count.las").points.size(), 10U);
  EXPECT_EQ(load("09_bad/pdal/bad_vlr_count.las").millimetresPerUnit, 1000.0);
  for (const char* const file : { "03_large/pdal/lone-star.laz",
         "09_bad/pdal/garbage_nVariableLength.las", "09_bad/pdal/no-points.las" })
  {
    EXPECT_THROW(load(file), scan::Error) << file;
  }
}

TEST(Las, HoldsTheSamePointsAsTheSameScanInText)
{
  if (!std::filesystem::exists(kFolder))
  {
    GTEST_SKIP() << kFolder << " is missing";
  }
  const Model las = load("04_point_formats/las/oni.las");
  const scan::MappedFile mapped(kFolder + "01_points/cgal/oni.pwn");
  scan::Execution execution;
  const scan::TriMesh text = scan::parsePointsText(mapped.bytes(), "oni", execution);
  ASSERT_EQ(las.points.size(), text.points.size());
  const auto before = [](const Vec3& a, const Vec3& b) {
    return std::array{ a.x, a.y, a.z } < std::array{ b.x, b.y, b.z };
  };
  std::vector<Vec3> a = las.points;
  std::vector<Vec3> b = text.points;
  std::sort(a.begin(), a.end(), before);
  std::sort(b.begin(), b.end(), before);
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    const Vec3 d = a[i] - b[i];
    largest = std::max(largest, std::sqrt(dot(d, d)));
  }
  EXPECT_LT(largest, 1e-5);
}

TEST(Las, KnowsItsOwn)
{
  const std::string bytes = Las().bytes();
  EXPECT_TRUE(scan::looksLikeLas(bytes));
  EXPECT_FALSE(scan::looksLikeLas(std::string_view("LAS")));
  EXPECT_FALSE(scan::looksLikeLas(std::string_view("ply\n")));
}
