// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/glb.h"

#include "readers/gltf.h"
#include "tests/readers/parsing.h"
#include "tests/writers/models.h"
#include "tests/writers/other_programs.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>

namespace
{

const auto kWrite = scan::test::aroundItsMiddle(scan::writeGlb);

using scan::Model;
using scan::Vec3;
using scan::test::grid;
using scan::test::moved;

std::string bytesOf(const Model& model)
{
  return scan::test::modelBytes(model, kWrite);
}

std::string jsonOf(const std::string& bytes)
{
  std::uint32_t size = 0;
  std::memcpy(&size, bytes.data() + 12, sizeof(size));
  return bytes.substr(20, size);
}

/// Compares with what assimp reads, which is in metres.
void expectSameInAssimp(const Model& model, double metresPerUnit)
{
  const scan::test::TemporaryFolder folder;
  scan::test::setContent(folder.file("model.glb"), bytesOf(model));
  scan::test::expectSame(
    scan::test::readWithAssimp(folder.file("model.glb")), moved(model, {}, metresPerUnit));
}

} // namespace

TEST(Glb, HasTheseBytesForATriangle)
{
  Model model;
  model.points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 2, 0 } };
  model.triangles = { { 0, 1, 2 } };
  const std::string bytes = bytesOf(model);
  const std::string json =
    R"({"asset":{"version":"2.0","generator":"Scanwrap"},"scene":0,"scenes":[{"nodes":[0]}],)"
    R"("nodes":[{"mesh":0,"scale":[0.001,0.001,0.001]}],)"
    R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"mode":4,"indices":1,)"
    R"("material":0}]}],)"
    R"("accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3",)"
    R"("min":[0.0,0.0,0.0],"max":[1.0,2.0,0.0]},)"
    R"({"bufferView":1,"componentType":5125,"count":3,"type":"SCALAR"}],)"
    R"("bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":36,"target":34962},)"
    R"({"buffer":0,"byteOffset":36,"byteLength":12,"target":34963}],)"
    R"("buffers":[{"byteLength":48}],"materials":[{"pbrMetallicRoughness":{)"
    R"("metallicFactor":0.0,"roughnessFactor":0.8},"doubleSided":true}]})";
  const std::string buffer("\0\0\0\0\0\0\0\0\0\0\0\0"
                           "\0\0\x80?\0\0\0\0\0\0\0\0"
                           "\0\0\0\0\0\0\0@\0\0\0\0"
                           "\0\0\0\0\1\0\0\0\2\0\0\0",
    48);
  EXPECT_EQ(jsonOf(bytes).substr(0, json.size()), json);
  EXPECT_EQ(jsonOf(bytes).find_first_not_of(' ', json.size()), std::string::npos);
  EXPECT_EQ(bytes.substr(0, 8), std::string("glTF\2\0\0\0", 8));
  EXPECT_EQ(bytes.size() % 4, 0U);
  std::uint32_t size = 0;
  std::memcpy(&size, bytes.data() + 8, sizeof(size));
  EXPECT_EQ(size, bytes.size());
  EXPECT_EQ(bytes.substr(bytes.size() - 56), std::string("\x30\0\0\0BIN\0", 8) + buffer);
}

TEST(Glb, KeepsModelsInAssimp)
{
  if (!scan::test::hasAssimp())
  {
    GTEST_SKIP() << "the program assimp is missing";
  }
  Model closed = grid(100, 100, true);
  expectSameInAssimp(closed, 0.001);
  closed.millimetresPerUnit = 25.4;
  expectSameInAssimp(closed, 0.0254);
  Model open = moved(grid(20, 20, false), { 100, 200, 300 });
  open.millimetresPerUnit = 1000.0;
  expectSameInAssimp(open, 1.0);
  expectSameInAssimp(scan::test::nonManifold(), 0.001);
}

TEST(Glb, SubtractsTheCentreOfAModelFarFromTheOrigin)
{
  const Vec3 centre{ 665187.25, -5648349.5, 12345671.0 }; // the middle is 7 above
  const std::string bytes = bytesOf(moved(grid(30, 30, true), centre));
  const std::string json = jsonOf(bytes);
  EXPECT_NE(json.find("\"translation\":[665.18725,-5648.3495,12345.678]"), std::string::npos)
    << json;
  float first[3] = {};
  const std::size_t buffer = 20 + json.size() + 8;
  std::memcpy(first, bytes.data() + buffer, sizeof(first));
  EXPECT_EQ(first[0], 40.0F);
  EXPECT_EQ(first[1], 0.0F);
}

TEST(Glb, KeepsCoordinatesThatFloatsHold)
{
  Model model;
  model.points = { { 1e6, 0, 0 }, { 1e6 + 1, 0, 0 }, { 1e6, 0.5, 3 } };
  model.triangles = { { 0, 1, 2 } };
  const std::string json = jsonOf(bytesOf(model));
  EXPECT_EQ(json.find("translation"), std::string::npos) << json;
  EXPECT_NE(json.find(R"("min":[1000000.0,0.0,0.0],"max":[1000001.0,0.5,3.0])"), std::string::npos);
}

TEST(Glb, HoldsColoursAndNormalsOfAScan)
{
  Model scan;
  scan.points = { { 0, 0, 0 }, { 1, 0, 0 } };
  scan.colors = { { 255, 0, 7 }, { 1, 2, 3 } };
  scan.normals = { { 0, 0, 1 }, { 0, 1, 0 } };
  scan.millimetresPerUnit = 1000.0;
  const std::string bytes = bytesOf(scan);
  const std::string json = jsonOf(bytes);
  EXPECT_NE(json.find(R"({"attributes":{"POSITION":0,"NORMAL":1,"COLOR_0":2},"mode":0})"),
    std::string::npos)
    << json;
  EXPECT_NE(json.find(R"("count":2,"type":"VEC4","normalized":true)"), std::string::npos);
  EXPECT_NE(json.find(R"("nodes":[{"mesh":0}])"), std::string::npos);
  EXPECT_EQ(json.find("materials"), std::string::npos);
  // 7 of 255 is 0.00212 of the light, 139 of 65535; all channels up to 10 go by 19.9
  EXPECT_TRUE(
    bytes.ends_with(std::string("\xff\xff\0\0\x8b\0\xff\xff\x14\0\x28\0\x3c\0\xff\xff", 16)));
}

TEST(Glb, HoldsLightThatGivesEveryChannelBack)
{
  Model scan;
  for (unsigned i = 0; i < 256; ++i)
  {
    scan.points.push_back({ i * 1.0, 0, 0 });
    scan.colors.push_back({ static_cast<std::uint8_t>(i), 0, 255 });
  }
  const std::string bytes = bytesOf(scan);
  EXPECT_EQ(scan::test::parse(scan::parseGltf, bytes).colors, scan.colors);
  std::uint16_t grey = 0; // of channel 128: 0.2159, after IEC 61966-2-1
  std::memcpy(&grey, bytes.data() + bytes.size() - 128U * 8U, sizeof(grey));
  EXPECT_NEAR(grey / 65535.0, 0.2158605, 1e-5);
}

TEST(Glb, HasNormalsOfLengthOne)
{
  Model model = scan::test::oneTriangle();
  model.normals = { {}, { 0, 3, 4 }, { 0, 0, 1 } };
  const Model read = scan::test::parse(scan::parseGltf, bytesOf(model));
  EXPECT_LT(read.normals[0].z, -0.99999); // that of the triangle
  EXPECT_NEAR(read.normals[1].z, 0.8, 1e-7);
  Model scan = scan::test::threePoints();
  scan.normals.assign(3, {});
  EXPECT_EQ(scan::test::parse(scan::parseGltf, bytesOf(scan)).normals[1], (Vec3{ 0, 0, 1 }));
}

TEST(Glb, ComesBackFromTheReader)
{
  const Vec3 centre{ 665187.522077, -5648349.895035, 12345678.9 };
  Model model = moved(grid(40, 40, true), centre);
  model.colors.assign(model.points.size(), { 1, 2, 3 });
  model.normals.assign(model.points.size(), { 0, 0, 1 });
  const Model read = scan::test::parse(scan::parseGltf, bytesOf(model));
  EXPECT_EQ(read.triangles, model.triangles);
  EXPECT_EQ(read.colors, model.colors);
  EXPECT_EQ(read.normals, model.normals);
  EXPECT_EQ(read.millimetresPerUnit, 1000.0);
  ASSERT_EQ(read.points.size(), model.points.size());
  for (std::size_t i = 0; i < read.points.size(); ++i)
  {
    const Vec3 difference = read.points[i] * 1000.0 - model.points[i];
    EXPECT_LT(std::sqrt(dot(difference, difference)), 1e-5) << i;
  }
}

TEST(Glb, HoldsCurves)
{
  Model model = scan::test::withCurves(grid(5, 5, true));
  for (int i = 0; i < 2; ++i)
  {
    const Model read = scan::test::parse(scan::parseGltf, bytesOf(model));
    EXPECT_EQ(read.curves, model.curves);
    EXPECT_EQ(read.triangles, model.triangles);
    model.triangles.clear(); // curves alone
  }
}

TEST(Glb, HasLinesForAssimp)
{
  if (!scan::test::hasAssimp())
  {
    GTEST_SKIP() << "assimp is not installed";
  }
  Model model = scan::test::withCurves(grid(5, 5, true));
  model.triangles.clear();
  const scan::test::TemporaryFolder folder;
  scan::test::setContent(folder.file("a.glb"), bytesOf(model));
  // two segments of the open one, three of the closed one
  const std::string info = "assimp info " + folder.file("a.glb");
  EXPECT_EQ(std::system((info + " | grep -q -E '^Faces: +5$'").c_str()), 0);
  EXPECT_EQ(std::system((info + " | grep -q -E '^Primitive Types: +lines$'").c_str()), 0);
}

TEST(Glb, RefusesWhatItCannotHold)
{
  EXPECT_EQ(scan::test::writeError({}, kWrite), scan::ErrorCode::badInput);
  Model model = grid(5, 5, true);
  model.points[3].y = 1e40;
  EXPECT_EQ(scan::test::writeError(model, kWrite), scan::ErrorCode::limit);
}

TEST(Glb, StopsWhenCancelled)
{
  scan::test::expectCancels(grid(5, 5, true), kWrite);
}
