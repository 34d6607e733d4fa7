// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/stl.h"

#include "tests/readers/parsing.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <limits>

namespace
{

using scan::Model;
using scan::Triangle;
using scan::TriMesh;
using scan::Vec3;

Model parse(std::string_view text)
{
  return scan::test::parse(scan::parseStl, text);
}

std::string error(std::string_view text)
{
  return scan::test::parseError(scan::parseStl, text);
}

using Facet = std::array<float, 9>;

std::string binary(const std::vector<Facet>& facets, std::string header = "made by a test")
{
  header.resize(80, '\0');
  const auto count = static_cast<std::uint32_t>(facets.size());
  header.append(reinterpret_cast<const char*>(&count), 4);
  for (const Facet& facet : facets)
  {
    header.append(12, '\0');
    header.append(reinterpret_cast<const char*>(facet.data()), sizeof(facet));
    header.append(2, '\0');
  }
  return header;
}

const std::vector<Facet> kTwo = { { 0, 0, 0, 1, 0, 0, 1, 1, 0 },
  { -0.0F, 0, 0, 1, 1, -0.0F, 0, 1, 0 } };

const std::string kFacet = "facet normal 0 0 1\n outer loop\n  vertex 0 0 0\n  vertex 1 0 0\n"
                           "  vertex 1 1 0\n endloop\nendfacet\n";

} // namespace

TEST(Stl, WeldsEqualCornersAndTakesMinusZeroForZero)
{
  const TriMesh mesh = parse(binary(kTwo));
  const std::vector<Vec3> points = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } };
  const std::vector<Triangle> triangles = { { 0, 1, 2 }, { 0, 2, 3 } };
  EXPECT_EQ(mesh.points, points);
  EXPECT_EQ(mesh.triangles, triangles);
}

TEST(Stl, KeepsNeighboursOneBitApart)
{
  const float next = std::nextafter(1.0F, 2.0F);
  EXPECT_EQ(parse(binary({ { 0, 0, 0, 1, 0, 0, next, 0, 0 } })).points.size(), 3U);
}

TEST(Stl, DecidesBinaryBySize)
{
  EXPECT_EQ(parse(binary(kTwo, "solid but binary")).triangles.size(), 2U);
  EXPECT_EQ(parse(binary(kTwo, "solid but binary") + "tail").triangles.size(), 2U);
}

TEST(Stl, JoinsSeveralSolids)
{
  const TriMesh mesh =
    parse("solid vertex facet\n" + kFacet + "endsolid\r\nSOLID b\r\n" + kFacet + "endsolid b\n");
  EXPECT_EQ(mesh.points.size(), 3U);
  EXPECT_EQ(mesh.triangles.size(), 2U);
}

TEST(Stl, NotesAMissingEnd)
{
  EXPECT_EQ(parse("solid\n" + kFacet + "endsolid\n").note, "");
  EXPECT_EQ(parse(binary(kTwo)).note, "");
  EXPECT_EQ(
    parse("solid\n" + kFacet).note, "the text ends without 'endsolid'; the file may be truncated");
}

TEST(Stl, RefusesFilesWithoutFacets)
{
  const std::string expected = "file: no facet found; there is nothing to load";
  EXPECT_EQ(error("solid nothing\nendsolid nothing"), expected);
  EXPECT_EQ(error(binary({})), expected);
}

TEST(Stl, ReadsFacetsThatTheHeaderDoesNotAnnounce)
{
  std::string file = binary(kTwo);
  file.replace(80, 4, 4, '\0');
  EXPECT_EQ(parse(file).triangles.size(), 2U);
  EXPECT_EQ(error(file + "x"), "file: no facet found; there is nothing to load");
}

TEST(Stl, IgnoresNormals)
{
  std::string text = "\xef\xbb\xbfsolid\n" + kFacet + "endsolid\n\x1a";
  const std::size_t normal = text.find("normal ") + 7;
  text.replace(normal, text.find('\n', normal) - normal, "-1.#IND 1e999 nan");
  EXPECT_EQ(parse(text).triangles.size(), 1U);
  std::string file = binary(kTwo);
  file.replace(84, 12, std::string("\0\0\xc0\x7f\0\0\x20\x41\0\0\0\0", 12)); // nan 10 0
  EXPECT_TRUE(scan::looksLikeStl(file));
  EXPECT_EQ(parse(file).triangles.size(), 2U);
}

TEST(Stl, NamesThePlaceOfAnError)
{
  const std::string file = binary(kTwo);
  EXPECT_EQ(error(file.substr(0, 180)),
    "file: byte 180: the file ends after 1 of 2 facets; it is truncated or no STL file");
  EXPECT_NE(error("solid\n" + kFacet.substr(0, 40)).find("line 4: expected"), std::string::npos)
    << error("solid\n" + kFacet.substr(0, 40));
  EXPECT_NE(error("solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 zero\n")
              .find("line 4: expected a number, found 'zero'"),
    std::string::npos);
  EXPECT_NE(error("solid\nfact\n").find("line 2: expected 'facet'"), std::string::npos);
}

TEST(Stl, CountsUnusableCoordinates)
{
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_NE(
    error(binary({ { 0, 0, nan, 1, 0, 0, 1, 1, nan } })).find("2 of 3 points"), std::string::npos);
}

TEST(Stl, KnowsItsOwn)
{
  const auto looks = [](const std::string& head) { return scan::looksLikeStl(head); };
  EXPECT_TRUE(looks(binary(kTwo)));
  EXPECT_TRUE(looks("solid a\n" + kFacet));
  EXPECT_FALSE(looks("ply\nformat ascii 1.0\n"));
  EXPECT_FALSE(looks(std::string(200, '1')));
  std::string wide; // text of 16 bits
  for (int i = 0; i < 200; ++i)
  {
    wide += std::string("1\0", 2);
  }
  EXPECT_FALSE(looks(wide));
  EXPECT_FALSE(looks(std::string(200, '\xff')));
}
