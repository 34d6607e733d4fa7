// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/glb.h"

#include "filters/base/error.h"
#include "readers/gltf.h"
#include "tests/writers/assimp.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>

namespace
{

using scan::Model;
using scan::Vec3;
using scan::test::boundsOf;
using scan::test::torus;

std::string bytesOf(const Model& model)
{
  return scan::test::bytesOfModel(scan::writeGlb, model);
}

std::string jsonOf(const std::string& bytes)
{
  std::uint32_t size = 0;
  std::memcpy(&size, bytes.data() + 12, sizeof(size));
  return bytes.substr(20, size);
}

scan::ErrorCode codeOf(const Model& model)
{
  try
  {
    bytesOf(model);
  }
  catch (const scan::Error& error)
  {
    return error.code();
  }
  return scan::ErrorCode::internal;
}

/// Compares with what assimp reads, which is in metres.
void expectSameInAssimp(const Model& model, double metresPerUnit, double tolerance)
{
  const scan::test::TemporaryFolder folder;
  scan::test::setContent(folder.file("model.glb"), bytesOf(model));
  const scan::TriMesh read = scan::test::readWithAssimp(folder, folder.file("model.glb"));
  ASSERT_EQ(read.points.size(), model.points.size());
  ASSERT_EQ(read.triangles.size(), model.triangles.size());
  const double cubed = metresPerUnit * metresPerUnit * metresPerUnit;
  EXPECT_NEAR(scan::test::volumeOf(read), scan::test::volumeOf(model) * cubed,
    tolerance * (1.0 + std::abs(scan::test::volumeOf(model) * cubed)));
  const auto expected = boundsOf(model);
  const auto bounds = boundsOf(read);
  EXPECT_NEAR(bounds.low.x, expected.low.x * metresPerUnit, tolerance);
  EXPECT_NEAR(bounds.low.z, expected.low.z * metresPerUnit, tolerance);
  EXPECT_NEAR(bounds.high.x, expected.high.x * metresPerUnit, tolerance);
  EXPECT_NEAR(bounds.high.y, expected.high.y * metresPerUnit, tolerance);
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
    R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"mode":4,"indices":1}]}],)"
    R"("accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3",)"
    R"("min":[0.0,0.0,0.0],"max":[1.0,2.0,0.0]},)"
    R"({"bufferView":1,"componentType":5125,"count":3,"type":"SCALAR"}],)"
    R"("bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":36,"target":34962},)"
    R"({"buffer":0,"byteOffset":36,"byteLength":12,"target":34963}],)"
    R"("buffers":[{"byteLength":48}]})";
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
  Model closed = torus(100, {});
  expectSameInAssimp(closed, 0.001, 1e-7);
  closed.millimetresPerUnit = 25.4;
  expectSameInAssimp(closed, 0.0254, 1e-5);
  Model open = torus(20, { 100, 200, 300 });
  open.triangles.resize(open.triangles.size() - 7);
  open.millimetresPerUnit = 1000.0;
  expectSameInAssimp(open, 1.0, 1e-4);
  Model winged = torus(10, {}); // an edge with three triangles
  winged.points.push_back({ 0, 0, 100 });
  winged.triangles.push_back({ 0, 1, 100 });
  expectSameInAssimp(winged, 0.001, 1e-6);
}

TEST(Glb, SubtractsTheCentreOfAModelFarFromTheOrigin)
{
  const Vec3 centre{ 665187.25, -5648349.5, 12345678.0 };
  const std::string bytes = bytesOf(torus(30, centre));
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
  EXPECT_TRUE(bytes.ends_with(std::string("\xff\0\x07\xff\x01\x02\x03\xff", 8)));
}

TEST(Glb, ComesBackFromTheReader)
{
  const Vec3 centre{ 665187.522077, -5648349.895035, 12345678.9 };
  Model model = torus(40, centre);
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
  Model model = torus(5, {});
  model.curves = { { 3, 1, 4, 0, 2, 3, 0 }, { 3, 7 } };
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
  Model model = torus(5, {});
  model.triangles.clear();
  model.curves = { { 3, 1, 4, 0, 2, 3, 0 }, { 3, 7 } };
  const scan::test::TemporaryFolder folder;
  scan::test::setContent(folder.file("a.glb"), bytesOf(model));
  // two segments of the open one, three of the closed one
  const std::string info = "assimp info " + folder.file("a.glb");
  EXPECT_EQ(std::system((info + " | grep -q -E '^Faces: +5$'").c_str()), 0);
  EXPECT_EQ(std::system((info + " | grep -q -E '^Primitive Types: +lines$'").c_str()), 0);
}

TEST(Glb, RefusesWhatItCannotHold)
{
  EXPECT_EQ(codeOf({}), scan::ErrorCode::badInput);
  Model model = torus(5, {});
  model.points[3].y = 1e40;
  EXPECT_EQ(codeOf(model), scan::ErrorCode::limit);
}

TEST(Glb, StopsWhenCancelled)
{
  scan::CancelToken token;
  token.cancel();
  scan::Execution execution(1, token);
  const scan::test::TemporaryFolder folder;
  scan::OutputFile file(folder.file("x.glb"));
  EXPECT_THROW(scan::writeGlb(torus(5, {}), file, execution), scan::Cancelled);
}
