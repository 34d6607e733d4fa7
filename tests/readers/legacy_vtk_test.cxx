// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/legacy_vtk.h"

#include "tests/readers/damage.h"

#include <gtest/gtest.h>

#include <cstring>

using namespace scan;
using namespace scan::test;

namespace
{

const std::string kHead = "# vtk DataFile Version 3.0\nA quad\nASCII\nDATASET POLYDATA\n";
const std::string kQuad = kHead + "POINTS 4 double\n0 0 0 1 0 0 1 1 0.1 0 1 0\n";
const std::string kFaces = "POLYGONS 1 5\n4 0 1 2 3\n";

template <class Number>
std::string big(Number number)
{
  std::string bytes(sizeof(number), '\0');
  std::memcpy(bytes.data(), &number, sizeof(number));
  return { bytes.rbegin(), bytes.rend() };
}

template <class Number>
std::string big(const std::vector<Number>& numbers)
{
  std::string bytes;
  for (const Number number : numbers)
  {
    bytes += big(number);
  }
  return bytes;
}

std::string binaryQuad()
{
  return "# vtk DataFile Version 5.1\nA quad\nBINARY\nDATASET POLYDATA\n"
         "FIELD FieldData 1\nMillimetresPerUnit 1 1 double\n" +
    big(25.4) + "\nPOINTS 4 float\n" +
    big(std::vector<float>{ 0, 0, 0, 1, 0, 0, 1, 1, 0.5F, 0, 1, 0 }) +
    "\nMETADATA\nINFORMATION 0\n\nPOLYGONS 2 4\nOFFSETS vtktypeint64\n" +
    big(std::vector<std::int64_t>{ 0, 4 }) + "\nCONNECTIVITY vtktypeint64\n" +
    big(std::vector<std::int64_t>{ 0, 1, 2, 3 }) +
    "\nCELL_DATA 1\nSCALARS block int\nLOOKUP_TABLE default\n" + big(7) +
    "\nPOINT_DATA 4\nSCALARS height float 2\nLOOKUP_TABLE mine\n" +
    big(std::vector<float>(8, 2.0F)) + "\nLOOKUP_TABLE mine 1\nabcd" +
    "\nCOLOR_SCALARS Colors 4\n" + std::string("\1\2\3\xff\4\5\6\xff\7\x8\x9\xff\xa\xb\xc\xff") +
    "\nNORMALS Normals double\n" + big(std::vector<double>{ 0, 0, 1, 0, 0, 1, 0, 3, 4, 0, 0, 0 }) +
    "\n";
}

const std::vector<Triangle> kTwo = { { 0, 1, 2 }, { 0, 2, 3 } };

} // namespace

TEST(LegacyVtk, ReadsTextOfVersion3)
{
  const Model model = parse(parseLegacyVtk, kQuad + kFaces);
  ASSERT_EQ(model.points.size(), 4U);
  EXPECT_EQ(model.points[2], (Vec3{ 1.0, 1.0, 0.1 }));
  EXPECT_EQ(model.triangles, kTwo);
  EXPECT_TRUE(model.colors.empty());
  EXPECT_EQ(model.millimetresPerUnit, 0.0);
}

TEST(LegacyVtk, ReadsBinaryOfVersion5WithAttributes)
{
  const Model model = parse(parseLegacyVtk, binaryQuad());
  ASSERT_EQ(model.points.size(), 4U);
  EXPECT_EQ(model.points[2], (Vec3{ 1.0, 1.0, 0.5 }));
  EXPECT_EQ(model.triangles, kTwo);
  const std::vector<Color> colors = { { 1, 2, 3 }, { 4, 5, 6 }, { 7, 8, 9 }, { 10, 11, 12 } };
  EXPECT_EQ(model.colors, colors);
  const std::vector<Vec3> normals = { { 0, 0, 1 }, { 0, 0, 1 }, { 0, 0.6, 0.8 }, { 0, 0, 0 } };
  EXPECT_EQ(model.normals, normals);
  EXPECT_EQ(model.millimetresPerUnit, 25.4);
}

TEST(LegacyVtk, ReadsColoursAndFieldsAsText)
{
  const Model model = parse(parseLegacyVtk,
    kQuad + kFaces +
      "POINT_DATA 4\nFIELD FieldData 2\nnames 1 2 string\na%20b\nc\nids 1 4 int\n1 2 3 4\n"
      "COLOR_SCALARS c 3\n0 0.5 1\n1 1 1\n0 0 0\n0.2 0.4 0.6\n");
  const std::vector<Color> colors = { { 0, 128, 255 }, { 255, 255, 255 }, { 0, 0, 0 },
    { 51, 102, 153 } };
  EXPECT_EQ(model.colors, colors);
}

TEST(LegacyVtk, KeepsColoursAheadOfScalarsOfTwoColumns)
{
  const Model model = parse(parseLegacyVtk,
    kQuad + kFaces + "POINT_DATA 4\nCOLOR_SCALARS c 3\n" + "1 1 1 0 0 0 1 0 0 0 1 0\n" +
      "COLOR_SCALARS d 2\n1 1 1 1 1 1 1 1\n");
  ASSERT_EQ(model.colors.size(), 4U);
  EXPECT_EQ(model.colors[2], (Color{ 255, 0, 0 }));
}

TEST(LegacyVtk, SkipsBinaryStrings)
{
  const std::string letters(100, 'x'); // a length of two bytes
  const std::string text = "# vtk DataFile Version 5.1\nA quad\nBINARY\nDATASET POLYDATA\n"
                           "FIELD FieldData 1\nnames 1 3 string\n" +
    std::string("\xc2") + "ab" + std::string("\x80\x64", 2) + letters + "\xc0" +
    "\nPOINTS 1 float\n" + big(std::vector<float>{ 1, 2, 3 }) + "\n";
  EXPECT_EQ(parse(parseLegacyVtk, text).points, (std::vector<Vec3>{ { 1, 2, 3 } }));
  expectErrorOrModelWhenDamaged(parseLegacyVtk, text);
}

TEST(LegacyVtk, FillsConcavePolygonsInsideTheirBorder)
{
  const Model model = parse(
    parseLegacyVtk, kHead + "POINTS 4 float\n0 0 0 4 2 0 1 2 0 0 4 0\nPOLYGONS 1 5\n4 1 2 3 0\n");
  EXPECT_DOUBLE_EQ(areaOf(model), 5.0);
}

TEST(LegacyVtk, ReadsStripsAndSkipsLinesAndVertices)
{
  const Model model = parse(parseLegacyVtk,
    kQuad + "VERTICES 1 2\n1 0\nLINES 1 3\n2 0 1\nTRIANGLE_STRIPS 1 5\n4 0 1 2 3\n");
  const std::vector<Triangle> expected = { { 0, 1, 2 }, { 2, 1, 3 } };
  EXPECT_EQ(model.triangles, expected);
}

TEST(LegacyVtk, LeavesOutAttributesThatItDoesNotKnow)
{
  const Model model =
    parse(parseLegacyVtk, kQuad + kFaces + "POINT_DATA 4\nSOMETHING new 1\n1 2 3 4\n");
  EXPECT_EQ(model.triangles, kTwo);
}

TEST(LegacyVtk, IsRecognised)
{
  EXPECT_TRUE(looksLikeLegacyVtk(kQuad));
  EXPECT_FALSE(looksLikeLegacyVtk(std::string("# vtk")));
  EXPECT_FALSE(looksLikeLegacyVtk(std::string("ply\n")));
}

TEST(LegacyVtk, SaysWhatIsWrong)
{
  const auto errorOf = [](const std::string& text) { return parseError(parseLegacyVtk, text); };
  EXPECT_EQ(errorOf("ply\n"),
    "file: not a legacy VTK file: it does not start with '# vtk DataFile Version'");
  EXPECT_EQ(errorOf("# vtk DataFile Version 3.0\nt\nXML\n"),
    "file: line 3: expected ASCII or BINARY, found 'xml'");
  EXPECT_EQ(errorOf("# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\n"),
    "file: line 4: the data set is 'unstructured_grid'; only POLYDATA can be read");
  EXPECT_EQ(errorOf(kHead),
    "file: no points found; a legacy VTK file of PolyData has a line 'POINTS n type'");
  EXPECT_EQ(errorOf(kHead + "POINTS x float\n"), "file: line 5: expected a count, found 'x'");
  EXPECT_EQ(
    errorOf(kHead + "POINTS 1 bit\n"), "file: line 5: numbers of type 'bit' cannot be read");
  EXPECT_EQ(errorOf(kHead + "POINTS 40000000 float\n0 0 0\n"),
    "file: line 5: the file ends early: there are 40000000 times 3 numbers announced");
  EXPECT_EQ(errorOf(kHead + "POINTS 2 float\n0 0 0.0000000\n1 1\n"),
    "file: line 8: the file ends early, in the middle of numbers");
  EXPECT_EQ(
    errorOf(kHead + "POINTS 1 float\n0 0 z\n"), "file: line 6: expected a number, found 'z'");
  EXPECT_EQ(errorOf(kHead + "POINTS 2 float\n0 0 0\n0 inf 0\n"),
    "file: 1 of 2 points have coordinates that are not finite or exceed 1e50 (first: line 7); "
    "remove them");
  EXPECT_EQ(errorOf(kQuad + "POLYGONS 1 4\n3 0 1 4\n"),
    "file: line 8: cell 0 names point 4, but there are 4, counted from 0");
  EXPECT_EQ(errorOf(kQuad + "POLYGONS 1 4\n3 0 1 -2\n"),
    "file: line 8: cell 0 names point -1, but there are 4, counted from 0");
  EXPECT_EQ(errorOf(kQuad + "POLYGONS 2 4\n3 0 1 2\n"),
    "file: line 8: cell 1 is not within the list of its section");
  EXPECT_EQ(errorOf(kQuad + "POLYGONS 3 3\nOFFSETS int\n0 3 2\nCONNECTIVITY int\n0 1 2\n"),
    "file: line 11: cell 1 is not within the list of its section");
  EXPECT_EQ(errorOf(kQuad + "POLYGONS 2 3\nOFFSETS int\n0 3\n0 1 2\n"),
    "file: line 10: expected CONNECTIVITY");
  EXPECT_EQ(
    errorOf(kQuad + "FACES 1\n"), "file: line 7: expected a section of PolyData, found 'faces'");
  EXPECT_EQ(errorOf(kQuad + "POINT_DATA 5\n"), "file: line 7: data of 5 points, but there are 4");
}

TEST(LegacyVtk, EndsInErrorOrModelWhenDamaged)
{
  expectErrorOrModelWhenDamaged(parseLegacyVtk, kQuad + kFaces);
  expectErrorOrModelWhenDamaged(parseLegacyVtk, binaryQuad());
}
