// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/transforms.h"

#include "readers/mapped_file.h"
#include "readers/ply.h"
#include "tests/readers/parsing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <random>

namespace
{

using scan::Affine;
using scan::ScanTransform;
using scan::Vec3;

std::vector<ScanTransform> read(std::string_view text)
{
  return scan::parseTransforms(text, "file");
}

std::string error(std::string_view text)
{
  try
  {
    read(text);
  }
  catch (const scan::Error& wrong)
  {
    return wrong.code() == scan::ErrorCode::parse ? wrong.what() : "not a parse error";
  }
  return {};
}

void expectNear(const Vec3& a, const Vec3& b, double tolerance = 1e-12)
{
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(a.z, b.z, tolerance);
}

/// A quarter turn about z that takes x to y, then a move.
void expectQuarterTurn(const Affine& place)
{
  expectNear(place.point({ 1, 0, 0 }), { 10, 21, 30 });
  expectNear(place.point({ 0, 1, 2 }), { 9, 20, 32 });
}

} // namespace

TEST(Transforms, AreMatricesOrQuaternions)
{
  const auto found = read("# places\n"
                          "a.ply 0 -1 0 10\n 1 0 0 20\n 0 0 1 30\n 0 0 0 1\n"
                          "b.ply 0 -1 0 10  1 0 0 20  0 0 1 30\n\n"
                          "\"c d.ply\" 10 20 30  0 0 2 2 # any length\n"
                          "\"7\" 10 20 30 0 0 .7071067811865476 .7071067811865476");
  ASSERT_EQ(found.size(), 4U);
  for (const ScanTransform& transform : found)
  {
    SCOPED_TRACE(transform.name);
    expectQuarterTurn(transform.place);
  }
  EXPECT_EQ(found[2].name, "c d.ply");
  EXPECT_EQ(found[3].name, "7");
}

TEST(Transforms, ReadListsOfStanford)
{
  const auto found = read("camera 1 2 3 4 5 6 7\nbmesh a.ply 10 20 30 0 0 -2 2\r\n"
                          "mesh b.ply 10 20 30 0 0 -2 2\n");
  ASSERT_EQ(found.size(), 2U);
  expectQuarterTurn(found[0].place); // the quaternion turns the other way
  expectQuarterTurn(found[1].place);
}

TEST(Transforms, ReadListsOfMeshLab)
{
  const std::string one = "a.ply\n#\n0 -1 0 10 \n1 0 0 20 \n0 0 1 30 \n0 0 0 1 \n";
  const auto found = read("2\n" + one + "my scan.ply \n#\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n0\n");
  ASSERT_EQ(found.size(), 2U);
  expectQuarterTurn(found[0].place);
  expectNear(found[1].place.point({ 1, 2, 3 }), { 1, 2, 3 });
  EXPECT_NE(error("2\n" + one + "0\n").find("line 8"), std::string::npos);
  EXPECT_NE(error("1\n" + one + "0\n1\n").find("expected the end"), std::string::npos);
  EXPECT_NE(error("1.5\n" + one).find("the number of scans, found '1.5'"), std::string::npos);
}

TEST(Transforms, SayWhatIsWrong)
{
  EXPECT_EQ(error("a.ply 1 2 3\n"),
    "file: line 1: expected 16, 12 or 7 numbers behind the name of a scan, found 3 behind 'a.ply'");
  EXPECT_NE(error("a 0 0 0 0 0 0 1\na 0 0 0 0 0 0 1\n").find("line 2: 'a' stands here for"),
    std::string::npos);
  EXPECT_NE(error("a 0 0 0 0 0 0 0\n").find("no length"), std::string::npos);
  EXPECT_NE(error("a 0 0 0 0 0 nan 1\n").find("not finite"), std::string::npos);
  EXPECT_NE(error("a 1 0 0 0 0 1 0 0 0 0 0 0\n").find("flattens"), std::string::npos);
  EXPECT_NE(
    error("a 1 0 0 0 0 1 0 0 0 0 1 0 5 5 5 1\n").find("last row of the matrix"), std::string::npos);
  EXPECT_NE(error("a 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1 9\n").find("number '9'"), std::string::npos);
  EXPECT_NE(error("\"a 0 0 0 0 0 0 1\n").find("closing quote"), std::string::npos);
  EXPECT_NE(error("# nothing\n").find("no scan found"), std::string::npos);
}

TEST(Transforms, AreFoundByTheNameOfAFile)
{
  const auto list = read("a.ply 1 0 0 0 0 0 1\nscans/b 2 0 0 0 0 0 1\nb 3 0 0 0 0 0 1\n");
  EXPECT_EQ(scan::findTransform(list, "far/away/a.ply"), &list[0]);
  EXPECT_EQ(scan::findTransform(list, "scans/b.ply"), &list[1]);
  EXPECT_EQ(scan::findTransform(list, "b.ply"), &list[2]);
  EXPECT_EQ(scan::findTransform(list, "a.obj"), nullptr);
}

TEST(Transforms, EndInAnErrorOrAListWhateverTheText)
{
  const std::string good =
    "3\n\"a b\" 0 -1 0 10\n1 0 0 20\n0 0 1 30\n0 0 0 1\nmesh c 1 2 3 4 5 6 7\n";
  std::mt19937 random(3);
  for (int round = 0; round < 20000; ++round)
  {
    std::string text = good.substr(0, random() % (good.size() + 1));
    for (unsigned i = random() % 4; i > 0 && !text.empty(); --i)
    {
      text[random() % text.size()] = "0123456789 .-+eE\n#\"amesh\0"[random() % 25];
    }
    error(text); // crashes would show
  }
}

TEST(Transforms, BringTheScansOfTheBunnyTogether)
{
  const std::string folder = SCAN_SHARED_DIR "/data/02_range_scans/stanford_bunny/";
  if (!std::filesystem::exists(folder))
  {
    GTEST_SKIP() << folder << " is missing";
  }
  const auto modelOf = [](const std::string& path)
  {
    const scan::MappedFile file(path);
    scan::Execution execution;
    return scan::parsePly(file.bytes(), file.name(), execution);
  };
  const scan::MappedFile list(folder + "data/bun.conf");
  const auto transforms = scan::parseTransforms(list.bytes(), list.name());
  EXPECT_EQ(transforms.size(), 10U);
  // Distances to the vertices of the published reconstruction, in a grid of its cells: those of the
  // points to its surface have a median of 0.064 mm, and vertices are about 1 mm apart.
  const scan::Model truth = modelOf(folder + "reconstruction/bun_zipper.ply");
  for (const ScanTransform& transform : transforms)
  {
    SCOPED_TRACE(transform.name);
    const scan::Model model = modelOf(folder + "data/" + transform.name);
    std::vector<double> distances;
    for (std::size_t i = 0; i < model.points.size(); i += 500)
    {
      const Vec3 p = transform.place.point(model.points[i]);
      double nearest = 1.0;
      for (const Vec3& q : truth.points)
      {
        nearest = std::min(nearest, dot(q - p, q - p));
      }
      distances.push_back(std::sqrt(nearest));
    }
    std::ranges::sort(distances);
    EXPECT_LT(distances[distances.size() / 2], 0.0008);
    EXPECT_LT(distances[distances.size() * 9 / 10], 0.0015);
  }
}
