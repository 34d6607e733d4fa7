// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Real files from scanners and converters, where the shared folder is there.
#include "readers/mapped_file.h"
#include "readers/obj.h"
#include "readers/ply.h"
#include "readers/points_text.h"
#include "readers/stl.h"
#include "tests/readers/parsing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <ostream>

namespace
{

using scan::Model;
using scan::TriMesh;

struct Row
{
  scan::test::Parser parser;
  const char* file;
  std::size_t points;
  std::size_t triangles;

  friend void PrintTo(const Row& row, std::ostream* stream) { *stream << row.file; }
};

const std::string kFolder = SCAN_SHARED_DIR "/data/";

Model load(scan::test::Parser parser, const std::string& file)
{
  const scan::MappedFile mapped(kFolder + file);
  scan::Execution execution;
  return parser(mapped.bytes(), mapped.name(), execution);
}

class SharedFile : public testing::TestWithParam<Row>
{
};

class RefusedFile : public testing::TestWithParam<Row>
{
};

constexpr scan::test::Parser kText = scan::parsePointsText;
constexpr scan::test::Parser kPly = scan::parsePly;
constexpr scan::test::Parser kObj = scan::parseObj;
constexpr scan::test::Parser kStl = scan::parseStl;

const std::vector<Row> kRows = {
  { kPly, "01_points/cgal/b9.ply", 22300, 0 },
  { kPly, "01_points/cgal/ball.ply", 31374, 0 },
  { kText, "01_points/cgal/before_upsample.xyz", 850, 0 },
  { kText, "01_points/cgal/bunny_ran.pts", 35947, 0 },
  { kText, "01_points/cgal/cube.pwn", 50000, 0 },
  { kText, "01_points/cgal/fin90_with_PCA_normals.xyz", 757, 0 },
  { kText, "01_points/cgal/half.xyz", 325, 0 },
  { kPly, "01_points/cgal/hippo1.ply", 6104, 0 },
  { kText, "01_points/cgal/kitten.xyz", 5210, 0 },
  { kText, "01_points/cgal/ocean_r.xyz", 14550, 0 },
  { kText, "01_points/cgal/oni.pwn", 1435, 0 },
  { kText, "01_points/cgal/sphere926.pwn", 926, 0 },
  { kText, "01_points/cgal/sphere_20k.xyz", 21000, 0 },
  { kText, "01_points/cgal/thom1249.pts", 1248, 0 },
  { kText, "01_points/cgal/torus_ran.pts", 499, 0 },
  { kText, "01_points/hoppe/curve1.pts", 126, 0 },
  { kText, "01_points/hoppe/distcap.pts", 12745, 0 },
  { kText, "01_points/trimesh/points_cloudcompare.xyz", 101, 0 },
  { kPly, "02_range_scans/stanford_armadillo/ArmadilloBack_0.ply", 19283, 0 },
  { kPly, "02_range_scans/stanford_armadillo/ArmadilloBack_1.ply", 12150, 0 },
  { kPly, "02_range_scans/stanford_armadillo/ArmadilloBack_2.ply", 20832, 0 },
  { kPly, "02_range_scans/stanford_bunny/data/bun000.ply", 40256, 0 },
  { kPly, "02_range_scans/stanford_bunny/data/bun045.ply", 40097, 0 },
  { kPly, "02_range_scans/stanford_bunny/data/bun090.ply", 30379, 0 },
  { kPly, "02_range_scans/stanford_bunny/data/bun180.ply", 40251, 0 },
  { kPly, "02_range_scans/stanford_bunny/data/bun270.ply", 31701, 0 },
  { kPly, "02_range_scans/stanford_bunny/data/bun315.ply", 35336, 0 },
  { kPly, "02_range_scans/stanford_bunny/data/chin.ply", 37738, 0 },
  { kPly, "02_range_scans/stanford_bunny/data/ear_back.ply", 32193, 0 },
  { kPly, "02_range_scans/stanford_bunny/data/top2.ply", 38298, 0 },
  { kPly, "02_range_scans/stanford_bunny/data/top3.ply", 36023, 0 },
  { kPly, "02_range_scans/stanford_bunny/reconstruction/bun_zipper.ply", 35947, 69451 },
  { kPly, "02_range_scans/stanford_bunny/reconstruction/bun_zipper_res2.ply", 8171, 16301 },
  { kPly, "02_range_scans/stanford_bunny/reconstruction/bun_zipper_res3.ply", 1889, 3851 },
  { kPly, "02_range_scans/stanford_bunny/reconstruction/bun_zipper_res4.ply", 453, 948 },
  { kPly, "05_meshes/assimp/Wuson.ply", 11184, 3732 },
  { kStl, "05_meshes/assimp/Wuson.stl", 2117, 3732 },
  { kObj, "05_meshes/assimp/WusonOBJ.obj", 2117, 3732 },
  { kPly, "05_meshes/cgal/sphere.ply", 162, 320 },
  { kStl, "05_meshes/cgal/sphere.stl", 162, 320 },
  { kPly, "05_meshes/vtk/lucy.ply", 49987, 99970 },
  // odd, but legal or harmless
  { kObj, "09_bad/assimp/box_longline.obj", 8, 944 },
  { kObj, "09_bad/assimp/box_without_lineending.obj", 8, 12 },
  { kPly, "09_bad/assimp/cube_binary_header_with_RN_newline.ply", 8, 12 },
  { kPly, "09_bad/assimp/cube_binary_starts_with_nl.ply", 8, 12 },
  { kObj, "09_bad/assimp/point_cloud.obj", 3, 0 },
  { kPly, "09_bad/assimp/points.ply", 4, 0 },
  { kStl, "09_bad/assimp/triangle_with_empty_solid.stl", 3, 1 },
  { kStl, "09_bad/assimp/triangle_with_two_solids.stl", 6, 2 },
  { kStl, "09_bad/cgal/pig.stl", 8642, 16848 },
  { kObj, "09_bad/draco/deg_faces.obj", 6, 4 },
  { kObj, "09_bad/draco/degenerate_mesh.obj", 3, 1 },
  { kObj, "09_bad/draco/extra_vertex.obj", 10, 3 },
  { kObj, "09_bad/draco/non_manifold_wrap.obj", 10, 12 },
  { kStl, "09_bad/trimesh/busted.STL", 1941, 3878 },
  { kObj, "09_bad/trimesh/jacked.obj", 8, 12 },
  { kObj, "09_bad/trimesh/nancolor.obj", 8, 12 },
  { kObj, "09_bad/trimesh/negative_indices.obj", 8, 12 },
  { kObj, "09_bad/trimesh/notenoughindices.obj", 3, 1 },
  { kObj, "09_bad/trimesh/singlevn.obj", 4, 2 },
  { kStl, "09_bad/trimesh/soup.stl", 300, 100 },
};

const std::vector<Row> kRefused = {
  { kObj, "09_bad/assimp/box_UTF16BE.obj", 0, 0 },
  { kPly, "09_bad/assimp/crash-30d6d0f7c529b3b66b4131700b7a4580cd7082df.ply", 0, 0 },
  { kObj, "09_bad/assimp/empty.obj", 0, 0 },
  { kPly, "09_bad/assimp/empty.ply", 0, 0 },
  { kPly, "09_bad/assimp/issue623.ply", 0, 0 },
  { kObj, "09_bad/assimp/malformed.obj", 0, 0 },
  { kObj, "09_bad/assimp/malformed2.obj", 0, 0 },
  { kObj, "09_bad/assimp/number_formats.obj", 0, 0 },
  { kPly, "09_bad/draco/float_inf_point_cloud.ply", 0, 0 },
  { kObj, "09_bad/draco/inf_nan.obj", 0, 0 },
  { kStl, "09_bad/trimesh/empty.stl", 0, 0 },
};

bool isMissing(const Row& row)
{
  return !std::filesystem::exists(kFolder + row.file);
}

std::string nameOf(const testing::TestParamInfo<Row>& info)
{
  std::string name = info.param.file;
  std::replace_if(
    name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return name;
}

} // namespace

TEST_P(SharedFile, LoadsCompletely)
{
  if (isMissing(GetParam()))
  {
    GTEST_SKIP() << kFolder << GetParam().file << " is missing";
  }
  const TriMesh mesh = load(GetParam().parser, GetParam().file);
  EXPECT_EQ(mesh.points.size(), GetParam().points);
  EXPECT_EQ(mesh.triangles.size(), GetParam().triangles);
}

TEST_P(RefusedFile, EndsInOneClearLine)
{
  if (isMissing(GetParam()))
  {
    GTEST_SKIP() << kFolder << GetParam().file << " is missing";
  }
  try
  {
    load(GetParam().parser, GetParam().file);
    FAIL() << "accepted";
  }
  catch (const scan::Error& error)
  {
    const std::string message = error.what();
    EXPECT_EQ(error.code(), scan::ErrorCode::parse) << message;
    EXPECT_NE(message.find(GetParam().file), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    RecordProperty("message", message);
  }
}

INSTANTIATE_TEST_SUITE_P(Real, SharedFile, testing::ValuesIn(kRows), nameOf);
INSTANTIATE_TEST_SUITE_P(Real, RefusedFile, testing::ValuesIn(kRefused), nameOf);

TEST(SharedFiles, JoinTheRangeGridOfAScanTowardsTheScanner)
{
  const std::string file = "02_range_scans/stanford_bunny/data/bun000.ply";
  if (!std::filesystem::exists(kFolder + file))
  {
    GTEST_SKIP() << kFolder << file << " is missing";
  }
  const TriMesh mesh = load(scan::parsePlyRangeGrid, file);
  EXPECT_EQ(mesh.points.size(), 40256U);
  EXPECT_GT(mesh.triangles.size(), 70000U);
  const auto facing = std::count_if(mesh.triangles.begin(), mesh.triangles.end(),
    [&](const scan::Triangle& t)
    {
      const scan::Vec3& p = mesh.points[t[0]];
      return cross(mesh.points[t[1]] - p, mesh.points[t[2]] - p).z > 0.0;
    });
  // a few fold back where the surface turns away
  EXPECT_GT(static_cast<double>(facing), 0.999 * static_cast<double>(mesh.triangles.size()));
}

TEST(SharedFiles, HaveTheirColorsAndNormals)
{
  struct Expected
  {
    scan::test::Parser parser;
    const char* file;
    bool hasColors;
    bool hasNormals;
  };
  const Expected rows[] = {
    { kPly, "01_points/cgal/ball.ply", false, true },
    { kText, "01_points/cgal/cube.pwn", false, true },
    { kText, "01_points/cgal/fin90_with_PCA_normals.xyz", false, true },
    { kPly, "01_points/cgal/hippo1.ply", false, true },
    { kText, "01_points/cgal/kitten.xyz", false, true },
    { kText, "01_points/cgal/half.xyz", false, false },
    { kText, "01_points/cgal/oni.pwn", false, true },
    { kText, "01_points/trimesh/points_cloudcompare.xyz", true, false },
    { kPly, "02_range_scans/stanford_bunny/data/bun000.ply", false, false },
    { kPly, "05_meshes/assimp/Wuson.ply", false, true },
    { kPly, "05_meshes/trimesh/cycloidal.ply", true, false },
    { kPly, "08_deviation/metro/knot_orig_metro.ply", true, false },
    { kPly, "09_bad/assimp/points.ply", true, true },
    { kObj, "09_bad/trimesh/nancolor.obj", true, false },
    { kObj, "09_bad/trimesh/singlevn.obj", false, false },
  };
  for (const auto& [parser, file, hasColors, hasNormals] : rows)
  {
    if (!std::filesystem::exists(kFolder + file))
    {
      GTEST_SKIP() << kFolder << file << " is missing";
    }
    const Model model = load(parser, file);
    EXPECT_EQ(model.colors.size(), hasColors ? model.points.size() : 0) << file;
    EXPECT_EQ(model.normals.size(), hasNormals ? model.points.size() : 0) << file;
  }
  EXPECT_EQ(load(kText, "01_points/trimesh/points_cloudcompare.xyz").colors.front(),
    (scan::Color{ 117, 73, 49 }));
}

TEST(SharedFiles, HoldTheSameSurfaceInEveryFormat)
{
  if (!std::filesystem::exists(kFolder + "05_meshes/assimp/Wuson.stl"))
  {
    GTEST_SKIP() << kFolder << " is missing";
  }
  const auto area = [](scan::test::Parser parser, const char* file)
  { return scan::test::areaOf(load(parser, file)); };
  EXPECT_NEAR(area(kStl, "05_meshes/assimp/Wuson.stl"), 9.0258, 1e-4);
  EXPECT_NEAR(area(kPly, "05_meshes/assimp/Wuson.ply"), 9.0258, 1e-4);
  EXPECT_NEAR(area(kObj, "05_meshes/assimp/WusonOBJ.obj"), 9.0258, 1e-4);
}
