// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/off.h"

#include "readers/mapped_file.h"
#include "tests/readers/damage.h"

#include <gtest/gtest.h>

#include <array>
#include <filesystem>

namespace
{

using scan::Color;
using scan::Model;
using scan::Triangle;
using scan::Vec3;

const std::vector<Vec3> kSquare = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1.5, 0 }, { 0, 1.5, -2e-3 } };
const std::vector<Triangle> kFan = { { 0, 1, 2 }, { 0, 2, 3 } };
const std::string kVertices = "0 0 0\n1 0 0\n1 1.5 0\n0 1.5 -2e-3\n";
const std::string kFolder = SCAN_SHARED_DIR "/data/";

Model parse(std::string_view text)
{
  return scan::test::parse(scan::parseOff, text);
}

std::string error(std::string_view text)
{
  return scan::test::parseError(scan::parseOff, text);
}

void expectError(std::string_view text, const std::string& part)
{
  EXPECT_NE(error(text).find(part), std::string::npos) << text << "\n" << error(text);
}

/// A grid of squares, each cut in two: closed nowhere, every inner edge shared.
std::string grid(std::size_t width, bool isColored)
{
  std::string text = (isColored ? "COFF\n" : "OFF\n") + std::to_string(width * width) + " " +
    std::to_string(2 * (width - 1) * (width - 1)) + " 0\n";
  for (std::size_t i = 0; i < width * width; ++i)
  {
    text += std::to_string(0.001 * static_cast<double>(i % width)) + " " +
      std::to_string(0.002 * static_cast<double>(i / width)) + " 0.125" +
      (isColored ? " 10 20 " + std::to_string(i % 256) + " 255\n" : "\n");
  }
  for (std::size_t i = 0; i + width < width * width; ++i)
  {
    if (i % width + 1 < width)
    {
      const std::string corner = std::to_string(i);
      const std::string opposite = std::to_string(i + width + 1);
      text += "3 " + corner + " " + std::to_string(i + 1) + " " + opposite + "\n3 " + corner + " " +
        opposite + " " + std::to_string(i + width) + "\n";
    }
  }
  return text;
}

Model load(const std::string& file)
{
  const scan::MappedFile mapped(kFolder + file);
  scan::Execution execution;
  return scan::parseOff(mapped.bytes(), mapped.name(), execution);
}

} // namespace

TEST(Off, ReadsVerticesAndFansOfFaces)
{
  const Model model = parse("OFF\n4 4 0\n" + kVertices + "4 0 1 2 3\n2 0 1\n1 3\n0\n");
  EXPECT_EQ(model.points, kSquare);
  EXPECT_EQ(model.triangles, kFan);
  EXPECT_TRUE(model.colors.empty());
  EXPECT_TRUE(model.normals.empty());
  EXPECT_EQ(model.millimetresPerUnit, 0.0);
}

TEST(Off, AcceptsEveryPlaceOfTheCounts)
{
  const std::string body = "\n" + kVertices + "4 0 1 2 3";
  for (const char* const head : { "OFF 4 1 0", "OFF4 1 0", "OFF\r\n\r\n4 1",
         "OFF # a\n# b\n 4 1 5 #", "# tool\n#\n\nOFF\n4\t1\t0 # counts", "\xef\xbb\xbfOFF\n4 1 0" })
  {
    EXPECT_EQ(parse(head + body).points, kSquare) << head;
    EXPECT_EQ(parse(head + body).triangles, kFan) << head;
  }
}

TEST(Off, SkipsCommentsBlankLinesAndColorsOfFaces)
{
  const Model model = parse("OFF\n4 2 0\n\n0 0 0 # first\n1 0 0\n# between\n\n1 1.5 0\r\n"
                            "0 1.5 -2e-3\n3 0 1 2 255 0 0\n\n3 0 2 3 0.5 0.5 0.5 1 # last\n# end");
  EXPECT_EQ(model.points, kSquare);
  EXPECT_EQ(model.triangles, kFan);
}

TEST(Off, ReadsPointsWithoutFacesAsAScan)
{
  EXPECT_EQ(parse("OFF\n4 0 0\n" + kVertices).points, kSquare);
}

TEST(Off, ReadsColorsOfEitherRange)
{
  const std::vector<Color> expected = { { 255, 0, 0 }, { 0, 128, 255 } };
  EXPECT_EQ(parse("COFF\n2 0 0\n0 0 0 255 0 0\n1 1 1 0 128 255\n").colors, expected);
  EXPECT_EQ(parse("COFF\n2 0 0\n0 0 0 255 0 0 255\n1 1 1 0 128 255 255\n").colors, expected);
  EXPECT_EQ(parse("COFF\n2 0 0\n0 0 0 1 0 0 1\n1 1 1 0.0 0.5 1.0 1\n").colors, expected);
}

TEST(Off, TakesDarkColorsOfIntegersForWhatTheyAre)
{
  EXPECT_EQ(parse("COFF\n1 0 0\n0 0 0 2 1 0\n").colors, (std::vector<Color>{ { 2, 1, 0 } }));
}

TEST(Off, ReadsNormalsAtLengthOne)
{
  const Model model = parse("NOFF\n4 0 0\n0 0 0 0 0 2\n1 0 0 0 0 0\n1 1 1 nan 0 0\n"
                            "1 1 1 5e-324 5e-324 0\n");
  EXPECT_EQ(model.normals, (std::vector<Vec3>{ { 0, 0, 1 }, {}, {}, {} }));
}

TEST(Off, ReadsEveryCombinationOfKeywords)
{
  const Model both = parse("CNOFF\n1 0 0\n1 2 3 0 1 0 10 20 30 255\n");
  EXPECT_EQ(both.points, (std::vector<Vec3>{ { 1, 2, 3 } }));
  EXPECT_EQ(both.normals, (std::vector<Vec3>{ { 0, 1, 0 } }));
  EXPECT_EQ(both.colors, (std::vector<Color>{ { 10, 20, 30 } }));
  EXPECT_EQ(parse("STOFF\n1 0 0\n1 2 3 0.25 0.75\n").points, both.points);
  const Model all = parse("STCNOFF\n1 0 0\n1 2 3 0 1 0 10 20 30 255 0.25 0.75\n");
  EXPECT_EQ(all.normals, both.normals);
  EXPECT_EQ(all.colors, both.colors);
}

TEST(Off, ReadsTheLettersOfTheKeywordInAnyOrder)
{
  const Model model = parse("NCOFF\n1 0 0\n1 2 3 0 1 0 10 20 30 255\n");
  EXPECT_EQ(model.normals, (std::vector<Vec3>{ { 0, 1, 0 } }));
  EXPECT_EQ(model.colors, (std::vector<Color>{ { 10, 20, 30 } }));
  EXPECT_EQ(parse("CSTOFF\n1 0 0\n1 2 3 10 20 30 255 0.25 0.75\n").colors, model.colors);
  EXPECT_EQ(parse("off\n4 0 0\n" + kVertices).points, kSquare);
  EXPECT_EQ(parse("coff\n1 0 0\n1 2 3 10 20 30\n").colors, model.colors);
}

TEST(Off, ReadsColorsAheadOfNormalsAsMeshLabWritesThem)
{
  const std::vector<Vec3> normals = { { 0, 1, 0 }, { 0, 0.6, -0.8 } };
  const std::vector<Color> colors = { { 10, 20, 30 }, { 0, 1, 0 } };
  for (const char* const opacity : { "", " 255" })
  {
    const auto colorsFirst = [&](const std::string& rgb, const std::string& normal)
    { return "1 2 3 " + rgb + opacity + " " + normal + "\n"; };
    const Model model = parse(
      "NCOFF\n2 0 0\n" + colorsFirst("10 20 30", "0 1 0") + colorsFirst("0 1 0", "0 0.6 -0.8"));
    EXPECT_EQ(model.normals, normals);
    EXPECT_EQ(model.colors, colors);
  }
}

TEST(Off, NeedsNoKeyword)
{
  EXPECT_EQ(parse("4 1 0\n" + kVertices + "4 0 1 2 3\n").triangles, kFan);
}

TEST(Off, FillsConcavePolygonsInsideTheirBorder)
{
  const Model model = parse("OFF\n4 1 0\n0 0 0\n4 2 0\n1 2 0\n0 4 0\n4 1 2 3 0\n");
  EXPECT_DOUBLE_EQ(scan::test::areaOf(model), 5.0);
}

TEST(Off, LeavesOutPointsThatAreNoNumberWithTheirColours)
{
  const Model model = parse("COFF\n3 0 0\n0 0 0 1 2 3\nnan 0 0 4 5 6\n1 1 1 7 8 9\n");
  EXPECT_EQ(model.points.size(), 2U);
  EXPECT_EQ(model.colors, (std::vector<Color>{ { 1, 2, 3 }, { 7, 8, 9 } }));
  expectError("OFF\n4 1 0\n0 0 0\n1 0 0\n0 1 0\nnan 0 0\n3 0 1 2\n", "1 of 4 points");
}

TEST(Off, RefusesCountsThatLie)
{
  EXPECT_EQ(error("OFF\n5 1 0\n" + kVertices + "4 0 1 2 3\n"),
    "file: line 8: the file ends after 0 of 1 faces; it is truncated or the counts are wrong");
  EXPECT_EQ(error("OFF\n4 2 0\n" + kVertices + "4 0 1 2 3\n"),
    "file: line 8: the file ends after 1 of 2 faces; it is truncated or the counts are wrong");
  expectError("OFF\n4 1 0\n0 0 0\n1.25 1.25 1.25\n", "the file ends after 2 of 4 vertices");
  expectError("OFF\n4 1 0\n" + kVertices + "4 0 1 2 3\n3 0 1 2\n", "line 8: text follows");
  expectError("OFF\n353535235358 6 0\n" + kVertices, "more than the file can hold");
  expectError("OFF\n4 353535235358 0\n" + kVertices, "more than the file can hold");
  expectError("OFF\n99999999999999999999999 6 0\n", "line 2: expected the number of vertices");
  expectError("OFF\n0 0 0\n", "no vertex");
}

TEST(Off, NamesTheMalformedLine)
{
  const std::string head = "OFF\n4 1 0\n" + kVertices;
  EXPECT_EQ(error(head + "3 0 1 4\n"),
    "file: line 7: a face refers to vertex 4, but there are 4, counted from 0");
  expectError(head + "3 0 -1 2\n", "line 7: expected a corner of a face on its line, found '-1'");
  expectError(head + "3 0 1\n", "line 7: expected a corner");
  expectError(head + "3 0 1 2.0\n", "line 7: expected a corner");
  expectError(head + "x 0 1 2\n", "line 7: expected the number of corners of a face, found 'x'");
  expectError("OFF\n1 0 0\n1 2\n3 4 5\n", "line 3: expected three coordinates");
  expectError("OFF\n1 0 0\n1 2 3e\n", "line 3: expected three coordinates, found '3e'");
  expectError("OFF\n-1 0 0\n", "line 2: expected the number of vertices, found '-1'");
  expectError("OFF\n4\n" + kVertices, "line 2: expected the number of faces");
  expectError("COFF\n1 0 0\n0 0 0 1\n", "line 3: expected a colour");
  expectError("COFF\n1 0 0\n0 0 0 1 256 0\n", "line 3: a colour must be");
  expectError("NOFF\n1 0 0\n0 0 0 1\n", "line 3: expected a normal");
}

TEST(Off, RefusesOtherFormsAndFormats)
{
  expectError("4OFF\n1 0 0\n0 0 0 1\n", "three dimensions");
  expectError("nOFF\n3\n1 0 0\n0 0 0\n", "three dimensions");
  expectError("OFF BINARY\n\1\2\3", "binary");
  expectError("v 0 0 0\n", "line 1: expected OFF");
  expectError("OFFICE\n", "expected OFF");
  expectError("", "expected OFF");
}

TEST(Off, CountsUnusableCoordinates)
{
  expectError("OFF\n3 0 0\n0 0 0\ninf 0 0\n1e60 0 0\n", "2 of 3 points");
}

TEST(Off, EndsInErrorOrModelWhenDamaged)
{
  scan::test::expectErrorOrModelWhenDamaged(scan::parseOff, grid(12, true));
  scan::test::expectErrorOrModelWhenDamaged(scan::parseOff,
    "# c\nSTCNOFF 3 1 0\n0 0 0 0 0 1 1 0 0 1 .5 .5\n0 1 0 0 0 1 1 0 0 1 .5 .5\n"
    "1 0 0 0 0 1 1 0 0 1 .5 .5\n3 0 1 2\n");
}

TEST(Off, ReadsAMillionTriangles)
{
  const std::string text = grid(708, false);
  std::size_t reports = 0;
  scan::Execution execution(1, {}, [&](std::string_view, double) { ++reports; });
  execution.plan({ { "read", 1.0 } });
  const Model model = scan::parseOff(text, "file", execution);
  EXPECT_EQ(model.points.size(), 708U * 708U);
  EXPECT_EQ(model.triangles.size(), 2U * 707U * 707U);
  EXPECT_EQ(
    model.triangles.back(), (Triangle{ 708U * 706U + 706U, 708U * 708U - 1U, 708U * 707U + 706U }));
  EXPECT_GE(reports, text.size() >> 21U);
}

TEST(Off, StopsWhenCancelled)
{
  scan::CancelToken token;
  token.cancel();
  scan::Execution execution(1, token);
  EXPECT_THROW(scan::parseOff(grid(4, false), "file", execution), scan::Cancelled);
}

TEST(Off, KnowsItsOwn)
{
  const auto looks = [](std::string_view head) {
    return scan::looksLikeOff({ head.data(), head.size() });
  };
  EXPECT_TRUE(looks("OFF\n1 0 0\n"));
  EXPECT_TRUE(looks("# tool\n\nCOFF 1 0 0\n"));
  EXPECT_TRUE(looks("OFF8 12 0\n"));
  EXPECT_TRUE(looks("4OFF\n"));
  EXPECT_FALSE(looks(""));
  EXPECT_FALSE(looks("# only\n"));
  EXPECT_FALSE(looks("OFFICE\n"));
  EXPECT_FALSE(looks("ply\n"));
}

TEST(Off, ReadsRealFiles)
{
  if (!std::filesystem::exists(kFolder))
  {
    GTEST_SKIP() << kFolder << " is missing";
  }
  const std::pair<const char*, std::array<std::size_t, 2>> rows[] = {
    { "05_meshes/assimp/Wuson.off", { 3205, 3732 } },
    { "05_meshes/cgal/am.off", { 3662, 7320 } },
    { "05_meshes/cgal/anchor.off", { 519, 1050 } },
    { "05_meshes/cgal/anchor_dense.off", { 3793, 7598 } },
    { "05_meshes/cgal/bear.off", { 13826, 27648 } },
    { "05_meshes/cgal/blobby-shuffled.off", { 2027, 4050 } },
    { "05_meshes/cgal/bones.off", { 2154, 4204 } },
    { "05_meshes/cgal/cylinder_locally_refined.off", { 8285, 16442 } },
    { "05_meshes/cgal/elephant-with-holes.off", { 2798, 4463 } },
    { "05_meshes/cgal/fandisk.off", { 6475, 12946 } },
    { "05_meshes/cgal/mannequin-devil.off", { 12977, 25888 } },
    { "05_meshes/cgal/mech-holes-shark.off", { 5246, 10192 } },
    { "05_meshes/cgal/refined_elephant.off", { 44460, 88928 } },
    { "05_meshes/cgal/sphere966.off", { 926, 1848 } },
    { "05_meshes/cgal/turbine.off", { 9210, 18460 } },
    { "09_bad/cgal/boeing.off", { 2741, 2564 } },
    { "09_bad/cgal/degtri_sliding.off", { 8, 8 } },
    { "09_bad/cgal/non_manifold_face_graph.off", { 24, 21 } },
  };
  for (const auto& [file, counts] : rows)
  {
    const Model model = load(file);
    EXPECT_EQ(model.points.size(), counts[0]) << file;
    EXPECT_EQ(model.triangles.size(), counts[1]) << file;
  }
  for (const char* const file : { "OutOfMemory", "empty", "invalid" })
  {
    EXPECT_THROW(load("09_bad/assimp/" + std::string(file) + ".off"), scan::Error) << file;
  }
}

TEST(Off, ReadsTheVolumeOfARealSolid)
{
  if (!std::filesystem::exists(kFolder))
  {
    GTEST_SKIP() << kFolder << " is missing";
  }
  const Model model = load("05_meshes/cgal/am.off");
  double volume = 0.0;
  for (const auto& [a, b, c] : model.triangles)
  {
    volume += dot(model.points[a], cross(model.points[b], model.points[c])) / 6.0;
  }
  EXPECT_NEAR(volume, 7.0, 1e-5);
}
