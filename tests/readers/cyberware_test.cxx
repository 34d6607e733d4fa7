// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/cyberware.h"

#include "tests/readers/cyberware_files.h"
#include "tests/readers/parsing.h"

#include <gtest/gtest.h>

#include <numbers>

namespace
{

using scan::CyberwareScan;
using scan::Model;
using scan::Triangle;
using scan::Vec3;
using scan::test::cyberwareBinary;
using scan::test::cyberwareLines;
using scan::test::CyberwareMap;
using scan::test::cyberwarePoints;
using scan::test::cyberwareSamples;
using scan::test::cyberwareText;
using scan::test::kCyberwareVoid;
using scan::test::mapWithVoids;

Model readPoints(std::span<const char> bytes, std::string_view name, scan::Execution& execution)
{
  return scan::parseCyberware(bytes, name, execution);
}

CyberwareScan readMesh(
  std::span<const char> bytes, std::string_view name, scan::Execution& execution)
{
  return scan::parseCyberwareScan(bytes, name, { .mesh = true }, execution);
}

Model points(const std::string& bytes)
{
  return scan::test::parse(readPoints, bytes);
}

CyberwareScan mesh(const std::string& bytes)
{
  return scan::test::parse(readMesh, bytes);
}

std::string error(const std::string& bytes)
{
  return scan::test::parseError(readPoints, bytes);
}

bool contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

std::string replaced(std::string text, const std::string& from, const std::string& to)
{
  const std::size_t at = text.find(from);
  return at == std::string::npos ? "nothing to replace" : text.replace(at, from.size(), to);
}

/// The volume between the triangles and the origin, positive when they face away from it.
double volume(const Model& model)
{
  double sum = 0.0;
  for (const auto& [a, b, c] : model.triangles)
  {
    sum += dot(model.points[a], cross(model.points[b], model.points[c])) / 6.0;
  }
  return sum;
}

/// The heights of the triangles' normals along z.
std::vector<bool> facesUp(const Model& model)
{
  std::vector<bool> result;
  for (const auto& [a, b, c] : model.triangles)
  {
    const Vec3& p = model.points[a];
    result.push_back(cross(model.points[b] - p, model.points[c] - p).z > 0.0);
  }
  return result;
}

std::vector<std::string> everyHeader(const CyberwareMap& map)
{
  return { cyberwareText(map), cyberwareBinary(map, 114), cyberwareBinary(map, 122),
    cyberwareBinary(map, 128), cyberwareBinary(map, 114, false), cyberwareBinary(map, 122, false),
    cyberwareBinary(map, 128, false) };
}

} // namespace

TEST(Cyberware, ReadsTheSamePointsFromEveryHeader)
{
  for (const char* const space : { "CYLINDRICAL", "CARTESIAN", "BILATERAL" })
  {
    const CyberwareMap map = mapWithVoids(space);
    ASSERT_EQ(cyberwarePoints(map).size(), 21U); // 24 samples in the window, 3 void
    for (const std::string& bytes : everyHeader(map))
    {
      const Model model = points(bytes);
      EXPECT_EQ(model.points, cyberwarePoints(map)) << space;
      EXPECT_EQ(model.millimetresPerUnit, 1.0);
      EXPECT_TRUE(model.triangles.empty());
      EXPECT_TRUE(scan::looksLikeCyberware(bytes));
    }
  }
}

TEST(Cyberware, ReadsTheWholeGridWithoutAWindow)
{
  const CyberwareMap map;
  for (const std::string& bytes : everyHeader(map))
  {
    EXPECT_EQ(points(bytes).points, cyberwarePoints(map));
  }
  EXPECT_EQ(points(replaced(cyberwareText(map), "SMOOTHED=1\n", "LGMIN=6\n")).points.size(), 10U);
}

TEST(Cyberware, PlacesTheFirstSampleTowardsMinusZ)
{
  CyberwareMap map;
  map.latitudes = 1;
  map.longitudes = 2;
  map.longitudeStep = 1570796;
  map.samples = { 2000, 3000 };
  const Model left = points(cyberwareText(map));
  EXPECT_EQ(left.points[0], (Vec3{ 0, 0, -64 }));
  EXPECT_NEAR(left.points[1].x, 96.0, 1e-4);
  map.isRightHanded = true;
  EXPECT_NEAR(points(cyberwareText(map)).points[1].x, -96.0, 1e-4);
}

TEST(Cyberware, KeepsNegativeDepthsButNoNegativeRadii)
{
  CyberwareMap map;
  map.samples[3] = -1;
  map.samples[17] = kCyberwareVoid;
  const CyberwareScan round = mesh(cyberwareText(map));
  EXPECT_EQ(round.model.points.size(), 38U);
  EXPECT_EQ(round.model.note, "samples with a radius below zero left out: 1");
  map.space = "CARTESIAN";
  const CyberwareScan flat = mesh(cyberwareText(map));
  EXPECT_EQ(flat.model.points.size(), 39U);
  EXPECT_EQ(flat.model.points[3].z, -0.032);
  EXPECT_EQ(flat.model.note, "");
}

TEST(Cyberware, AcceptsWhatOtherProgramsWrite)
{
  const CyberwareMap map;
  std::string header = cyberwareLines(map);
  for (std::size_t at = 0; (at = header.find('\n', at)) != header.npos; at += 2)
  {
    header.insert(at, 1, '\r');
  }
  EXPECT_EQ(points(header + "DATA=\r\n" + cyberwareSamples(map)).points, cyberwarePoints(map));
  EXPECT_EQ(points(cyberwareText(map) + "more").points, cyberwarePoints(map));
  const std::string bare = replaced(cyberwareText(map), "SPACE=CYLINDRICAL\n", "");
  EXPECT_EQ(points(replaced(bare, "LGSHIFT=8\n", "")).points, cyberwarePoints(map));
  EXPECT_EQ(points(replaced(bare, "SMOOTHED=1\n", "NLT=77\n")).points, cyberwarePoints(map));
}

TEST(Cyberware, ClosesAScanOfAFullTurn)
{
  const double area = 8 * 0.5 * 32 * 32 * std::sin(std::numbers::pi / 4); // of the octagon
  // the side of a prism: two thirds of its volume lie between it and the origin
  const double expected = area * 4 * 1.559 * 2.0 / 3.0;
  for (const bool isRightHanded : { false, true })
  {
    for (const bool isInsideOut : { false, true })
    {
      CyberwareMap map;
      map.isRightHanded = isRightHanded;
      map.isInsideOut = isInsideOut;
      for (const std::string& bytes : everyHeader(map))
      {
        const Model model = mesh(bytes).model;
        EXPECT_EQ(model.points, cyberwarePoints(map));
        EXPECT_EQ(model.triangles.size(), 8U * 4 * 2);
        EXPECT_NEAR(volume(model), isInsideOut ? -expected : expected, expected * 1e-5);
      }
    }
  }
}

TEST(Cyberware, LeavesAPartOfATurnOpen)
{
  CyberwareMap map;
  map.longitudeStep = 392699; // half a turn in all
  EXPECT_EQ(mesh(cyberwareText(map)).model.triangles.size(), 7U * 4 * 2);
  map.longitudeStep = 897598; // the last longitude is the first again
  EXPECT_EQ(mesh(cyberwareText(map)).model.triangles.size(), 7U * 4 * 2);
  map.longitudeStep = 785398;
  map.hasWindow = true;
  EXPECT_EQ(mesh(cyberwareText(map)).model.triangles.size(), 8U * 4 * 2);
  map.lastLongitude = 6;
  EXPECT_EQ(mesh(cyberwareText(map)).model.triangles.size(), 6U * 4 * 2);
}

TEST(Cyberware, MakesNoRoomForMoreTrianglesThanThereAre)
{
  CyberwareMap map;
  map.longitudes = 9;
  map.longitudeStep = 698132;
  map.samples.assign(45, 1000);
  const Model model = mesh(cyberwareText(map)).model;
  EXPECT_EQ(model.triangles.size(), 9U * 4 * 2);
  EXPECT_LE(model.triangles.capacity(), 2 * model.points.size());
}

TEST(Cyberware, MeshesNoCellWithAVoidCorner)
{
  CyberwareMap map;
  map.samples[2 * 5 + 2] = kCyberwareVoid;
  const CyberwareScan scan = mesh(cyberwareText(map));
  EXPECT_EQ(scan.model.triangles.size(), (8U * 4 - 4) * 2);
  EXPECT_EQ(scan.model.triangles[0], (Triangle{ 0, 6, 5 }));
  EXPECT_EQ(scan.model.triangles[1], (Triangle{ 0, 1, 6 }));
  EXPECT_EQ(scan.cells[12], 13U);
}

TEST(Cyberware, TurnsPlaneMapsTowardsZ)
{
  CyberwareMap map;
  map.space = "CARTESIAN";
  map.isRightHanded = true; // has no meaning without an angle
  EXPECT_EQ(facesUp(mesh(cyberwareText(map)).model), std::vector<bool>(7 * 4 * 2, true));
  map.isInsideOut = true;
  EXPECT_EQ(facesUp(mesh(cyberwareText(map)).model), std::vector<bool>(7 * 4 * 2, false));
}

TEST(Cyberware, KeepsTheHalvesOfABilateralMapApart)
{
  CyberwareMap map;
  map.space = "BILATERAL";
  map.latitudes = 6;
  map.samples.assign(48, 100);
  const CyberwareScan scan = mesh(cyberwareText(map));
  EXPECT_EQ(facesUp(scan.model), std::vector<bool>(7 * 4 * 2, true));
  EXPECT_EQ(scan.model.note, "the two halves of the map lie over each other");
  EXPECT_TRUE(contains(error(replaced(cyberwareText(map), "NLT=6", "NLT=5")), "odd number"));
}

TEST(Cyberware, ExplainsAMalformedHeader)
{
  const std::string text = cyberwareText(CyberwareMap());
  for (const std::string key : { "NLT", "NLG", "LTINCR", "LGINCR", "RSHIFT" })
  {
    EXPECT_EQ(error(replaced(text, "\n" + key + "=", "\nX=")),
      "file: the header lacks the line " + key + "=; this is no complete Cyberware file");
  }
  EXPECT_EQ(error(replaced(text, "NLT=5", "NLT=five")),
    "file: line 8: NLT must be a whole number, not 'five'");
  EXPECT_EQ(error(replaced(text, "NLT=5", "NLT=0")),
    "file: line 8: NLT is 0, but must be in 1 to 32767; the header is damaged");
  EXPECT_TRUE(contains(error(replaced(text, "NLG=8", "NLG=99999999999999999999")), "line 6"));
  EXPECT_TRUE(contains(error(replaced(text, "RSHIFT=5", "RSHIFT=17")), "0 to 16"));
  EXPECT_TRUE(contains(error(replaced(text, "LTINCR=1559", "LTINCR=-1")), "LTINCR is -1"));
  EXPECT_TRUE(contains(error(replaced(text, "SMOOTHED=1", "LTMIN=5")), "LTMIN is 5"));
  EXPECT_TRUE(contains(error(replaced(text, "SMOOTHED=1", "LGMIN=4\nLGMAX=3")), "LGMAX is 3"));
  EXPECT_EQ(error(replaced(text, "=CYLINDRICAL", "=ROUND")),
    "file: line 4: SPACE must be CYLINDRICAL, CARTESIAN or BILATERAL, not 'ROUND'");
  EXPECT_TRUE(contains(error(replaced(text, "DATA=", "DATUM")), "no line 'DATA='"));
  EXPECT_TRUE(contains(error(replaced(text, "DATA=", std::string(4096, '.') + "\nDATA=")), "4096"));
  EXPECT_TRUE(contains(error("solid of something else"), "no Cyberware header"));
  EXPECT_TRUE(contains(error("abc"), "no Cyberware header"));
}

TEST(Cyberware, ExplainsAMalformedBinaryHeader)
{
  std::string bytes = cyberwareBinary(CyberwareMap(), 122);
  EXPECT_TRUE(contains(error(bytes.substr(0, 121)), "ends inside its header of 122 bytes"));
  const auto broken = [&](std::size_t offset)
  { return error(std::string(bytes).replace(offset, 2, "\xff\xff")); };
  EXPECT_EQ(
    broken(58), "file: byte 58: NLT is -1, but must be in 1 to 32767; the header is damaged");
  EXPECT_TRUE(contains(broken(60), "byte 60: NLG"));
  EXPECT_TRUE(contains(broken(62), "byte 62: RSHIFT"));
  EXPECT_TRUE(contains(broken(70), "byte 70: LTINCR"));
  EXPECT_TRUE(contains(broken(74), "byte 74: LGINCR"));
  EXPECT_TRUE(contains(broken(90), "byte 90: LTMIN"));
  EXPECT_TRUE(contains(broken(96), "byte 96: LGMAX"));
  EXPECT_TRUE(contains(broken(6), "no Cyberware header"));
}

TEST(Cyberware, RefusesMissingSamples)
{
  const std::string text = cyberwareText(CyberwareMap());
  EXPECT_EQ(error(text.substr(0, text.size() - 1)),
    "file: the header announces 8 x 5 samples of two bytes, but only 79 of 80 bytes follow; the "
    "file is truncated");
  EXPECT_TRUE(contains(
    error(replaced(replaced(text, "NLT=5", "NLT=32767"), "NLG=8", "NLG=32767")), "truncated"));
  CyberwareMap map;
  map.samples.assign(40, kCyberwareVoid);
  EXPECT_TRUE(contains(error(cyberwareText(map)), "no sample of the map is valid"));
}

TEST(Cyberware, ClaimsNoOtherFile)
{
  const auto claims = [](std::string_view head) { return scan::looksLikeCyberware(head); };
  EXPECT_TRUE(claims("Cyberware Digitizer Data\n"));
  EXPECT_FALSE(claims(""));
  EXPECT_FALSE(claims("Wherever you go\n1 2 3\n"));
  EXPECT_FALSE(claims("solid x\n"));
  EXPECT_FALSE(claims("1 2 3\n"));
  std::string stl(200, '\0');
  stl[7] = 122;
  EXPECT_FALSE(claims(stl));
}

TEST(Cyberware, EndsInErrorOrPointsWhateverTheBytes)
{
  for (const char* const space : { "CYLINDRICAL", "BILATERAL" })
  {
    for (const std::string& bytes : everyHeader(mapWithVoids(space)))
    {
      for (std::size_t size = 0; size < bytes.size(); ++size)
      {
        EXPECT_NE(error(bytes.substr(0, size)), "") << "cut at " << size;
      }
      for (std::size_t at = 0; at < bytes.size(); ++at)
      {
        for (const int flip : { 0x01, 0x80, 0xff })
        {
          std::string changed = bytes;
          changed[at] = static_cast<char>(changed[at] ^ flip);
          EXPECT_NE(scan::test::parseError(readMesh, changed), "not a parse error");
        }
      }
    }
  }
}

TEST(Cyberware, StopsWhenCancelled)
{
  const std::string bytes = cyberwareText(CyberwareMap());
  const scan::CancelToken token;
  token.cancel();
  scan::Execution execution(1, token);
  EXPECT_THROW(scan::parseCyberware(bytes, "file", execution), scan::Cancelled);
}

TEST(CyberwareColors, FollowTheGridInEitherOrientation)
{
  CyberwareMap map = mapWithVoids("CYLINDRICAL"); // 9 longitudes of 6 latitudes
  const auto colorOf = [](std::size_t lg, std::size_t lt) {
    return scan::Color{ static_cast<std::uint8_t>(lg), static_cast<std::uint8_t>(lt), 7 };
  };
  scan::SgiImage upright{ 9, 6, {} };
  scan::SgiImage stored{ 6, 9, {} };
  scan::SgiImage doubled{ 18, 12, {} };
  for (std::size_t i = 0; i < 54; ++i)
  {
    upright.pixels.push_back(colorOf(i % 9, i / 9));
    stored.pixels.push_back(colorOf(i / 6, i % 6));
  }
  for (std::size_t i = 0; i < 216; ++i)
  {
    doubled.pixels.push_back(colorOf(i % 18 / 2, i / 18 / 2));
  }
  for (const scan::SgiImage& image : { upright, stored, doubled })
  {
    CyberwareScan scan = mesh(cyberwareText(map));
    scan::addCyberwareColors(scan, image);
    ASSERT_EQ(scan.model.colors.size(), scan.model.points.size());
    for (std::size_t i = 0; i < scan.cells.size(); ++i)
    {
      EXPECT_EQ(scan.model.colors[i], colorOf(scan.cells[i] / 6, scan.cells[i] % 6));
    }
  }
}

TEST(CyberwareColors, ReadASquareImageAsTheScanIsStored)
{
  CyberwareMap map;
  map.latitudes = map.longitudes = 2;
  map.samples = { 1, 2, 3, 4 };
  CyberwareScan scan = mesh(cyberwareText(map));
  const std::vector<scan::Color> pixels = { { 1 }, { 2 }, { 3 }, { 4 } };
  scan::addCyberwareColors(scan, { 2, 2, pixels });
  EXPECT_EQ(scan.model.colors, pixels);
  EXPECT_THROW(scan::addCyberwareColors(scan, {}), scan::Error);
}
