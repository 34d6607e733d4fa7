// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/gltf.h"

#include "readers/mapped_file.h"
#include "tests/readers/damage.h"
#include "tests/readers/temporary_folder.h"

#include <cstdint>
#include <cstdlib>
#include <filesystem>

namespace
{

using scan::Color;
using scan::Model;
using scan::Triangle;
using scan::Vec3;

template <class Number>
std::string raw(std::initializer_list<Number> values)
{
  return { reinterpret_cast<const char*>(values.begin()), values.size() * sizeof(Number) };
}

/// A GLB file; single quotes of the JSON stand for double ones.
std::string glb(std::string json, std::string buffer)
{
  std::replace(json.begin(), json.end(), '\'', '"');
  json.resize((json.size() + 3) / 4 * 4, ' ');
  buffer.resize((buffer.size() + 3) / 4 * 4, '\0');
  const auto number = [](std::size_t value) { return raw({ static_cast<std::uint32_t>(value) }); };
  return "glTF" + number(2) + number(28 + json.size() + buffer.size()) + number(json.size()) +
    "JSON" + json + number(buffer.size()) + std::string("BIN\0", 4) + buffer;
}

std::string replaced(std::string text, const std::string& from, const std::string& to)
{
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

Model parse(const std::string& bytes)
{
  return scan::test::parse(scan::parseGltf, bytes);
}

std::string error(const std::string& bytes)
{
  return scan::test::parseError(scan::parseGltf, bytes);
}

const std::string kBuffer = raw<float>({ 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0 }) +  // 0: a square
  raw<float>({ 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1 }) +                            // 48: normals
  raw<std::uint8_t>({ 255, 0, 7, 255, 1, 2, 3, 255, 4, 5, 6, 255, 7, 8, 9, 0 }) + // 96: colours
  raw<std::uint16_t>({ 0, 1, 2, 0, 2, 3 }) +                                      // 112: corners
  raw<std::uint8_t>({ 0, 1, 3, 2 });                                              // 124: a strip

const std::string kJson =
  "{'asset':{'version':'2.0'},'scene':0,'scenes':[{'nodes':[0]}],"
  "'nodes':[{'mesh':0}],"
  "'meshes':[{'primitives':[{'attributes':{'POSITION':0},'indices':3}]}],"
  "'accessors':["
  "{'bufferView':0,'componentType':5126,'count':4,'type':'VEC3','min':[0,0,0],'max':[1,1,0]},"
  "{'bufferView':0,'byteOffset':48,'componentType':5126,'count':4,'type':'VEC3'},"
  "{'bufferView':1,'componentType':5121,'normalized':true,'count':4,'type':'VEC4'},"
  "{'bufferView':2,'componentType':5123,'count':6,'type':'SCALAR'},"
  "{'bufferView':2,'byteOffset':12,'componentType':5121,'count':4,'type':'SCALAR'}],"
  "'bufferViews':[{'buffer':0,'byteLength':96},{'buffer':0,'byteOffset':96,'byteLength':16},"
  "{'buffer':0,'byteOffset':112,'byteLength':16}],"
  "'buffers':[{'byteLength':128}]}";

const std::vector<Vec3> kSquare = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } };
const std::vector<Triangle> kHalves = { { 0, 1, 2 }, { 0, 2, 3 } };

std::string square()
{
  return glb(kJson, kBuffer);
}

std::string squareWith(const std::string& from, const std::string& to)
{
  return glb(replaced(kJson, from, to), kBuffer);
}

constexpr const char* kPrimitive = "{'attributes':{'POSITION':0},'indices':3}";

} // namespace

TEST(Gltf, ReadsAnIndexedMeshInMetres)
{
  const Model model = parse(square());
  EXPECT_EQ(model.points, kSquare);
  EXPECT_EQ(model.triangles, kHalves);
  EXPECT_EQ(model.millimetresPerUnit, 1000.0);
  EXPECT_TRUE(model.colors.empty());
  EXPECT_TRUE(model.normals.empty());
}

TEST(Gltf, ReadsStripsFansAndTrianglesWithoutIndices)
{
  const auto withMode = [](const char* mode, const char* indices)
  {
    return parse(squareWith(kPrimitive,
                   std::string("{'attributes':{'POSITION':0},'mode':") + mode + indices + "}"))
      .triangles;
  };
  EXPECT_EQ(withMode("5", ",'indices':4"), (std::vector<Triangle>{ { 0, 1, 3 }, { 3, 1, 2 } }));
  EXPECT_EQ(withMode("6", ""), kHalves);
  EXPECT_EQ(withMode("0", ""), std::vector<Triangle>{});
  EXPECT_NE(error(squareWith(kPrimitive, "{'attributes':{'POSITION':0}}"))
              .find("triangles have 4 corners, which is not a multiple of three"),
    std::string::npos);
}

TEST(Gltf, ReadsLinesAsCurves)
{
  const auto withMode = [](const char* mode, const char* indices)
  {
    return parse(squareWith(kPrimitive,
                   std::string("{'attributes':{'POSITION':0},'mode':") + mode + indices + "}"))
      .curves;
  };
  EXPECT_EQ(withMode("1", ""), (scan::Polylines{ { 0, 1, 2, 3 }, { 2, 4 } }));
  EXPECT_EQ(withMode("2", ""), (scan::Polylines{ { 0, 1, 2, 3, 0 }, { 5 } }));
  EXPECT_EQ(withMode("3", ",'indices':4"), (scan::Polylines{ { 0, 1, 3, 2 }, { 4 } }));
  EXPECT_TRUE(withMode("3", "").corners.size() == 4 && withMode("4", ",'indices':3").empty());
}

TEST(Gltf, ReadsColoursAndNormals)
{
  const Model model = parse(squareWith(kPrimitive,
    "{'attributes':{'POSITION':0,'NORMAL':1,'COLOR_0':2},'indices':3},"
    "{'attributes':{'POSITION':0},'mode':0}"));
  ASSERT_EQ(model.points.size(), 8U);
  // the file has light, 7, 8 and 9 of 255
  EXPECT_EQ(model.colors[0], (Color{ 255, 0, 46 }));
  EXPECT_EQ(model.colors[3], (Color{ 46, 50, 53 }));
  EXPECT_EQ(model.colors[4], (Color{ 255, 255, 255 }));
  EXPECT_EQ(model.normals[2], (Vec3{ 0, 0, 1 }));
  EXPECT_EQ(model.normals[5], (Vec3{}));
}

TEST(Gltf, SharesVerticesBetweenPrimitivesOfAMesh)
{
  const Model model = parse(squareWith(
    kPrimitive, std::string(kPrimitive) + ",{'attributes':{'POSITION':0},'indices':4,'mode':5}"));
  EXPECT_EQ(model.points, kSquare);
  EXPECT_EQ(model.triangles.size(), 4U);
}

TEST(Gltf, AppliesTheTransformsOfNodes)
{
  const std::string nodes =
    "'nodes':[{'children':[1,2],'translation':[1e7,0,0],'rotation':[0,0,1,0],'scale':[2,2,2]},"
    "{'mesh':0,'matrix':[0,1,0,0,-1,0,0,0,0,0,1,0,0.1,0,5,1]},{'name':'empty'},{'mesh':0}]";
  const Model model = parse(squareWith("'nodes':[{'mesh':0}]", nodes));
  ASSERT_EQ(model.points.size(), 4U); // node 3 is not in the scene
  EXPECT_EQ(model.points[0], (Vec3{ 1e7 - 0.2, 0, 10 }));
  EXPECT_EQ(model.points[1], (Vec3{ 1e7 - 0.2, -2, 10 }));
  EXPECT_EQ(model.triangles, kHalves);
  const Model mirrored = parse(squareWith("{'mesh':0}", "{'mesh':0,'scale':[-1,1,1]}"));
  EXPECT_EQ(mirrored.triangles, (std::vector<Triangle>{ { 1, 0, 2 }, { 2, 0, 3 } }));
}

TEST(Gltf, ReadsEveryNodeWithoutScenes)
{
  const Model model = parse(squareWith("'scene':0,'scenes':[{'nodes':[0]}],'nodes':[{'mesh':0}]",
    "'nodes':[{'mesh':0},{'mesh':0,'children':[2]},{'mesh':0}]"));
  EXPECT_EQ(model.points.size(), 12U);
  EXPECT_EQ(model.triangles[5], (Triangle{ 8, 10, 11 }));
}

TEST(Gltf, ReadsEmbeddedBuffers)
{
  std::string json = R"({"buffers":[{"uri":"data:application/octet-stream;base64,)"
                     R"(AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAAEAAAAAA","byteLength":36}],)"
                     R"("bufferViews":[{"buffer":0,"byteLength":36}],"accessors":[{"bufferView":0,)"
                     R"("componentType":5126,"count":3,"type":"VEC3"}],"meshes":[{"primitives":)"
                     R"([{"attributes":{"POSITION":0}}]}],"asset":{"version":"2.0"}})";
  const Model model = parse(json);
  EXPECT_EQ(model.points, (std::vector<Vec3>{ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 2, 0 } }));
  EXPECT_EQ(model.triangles, (std::vector<Triangle>{ { 0, 1, 2 } }));
  EXPECT_TRUE(scan::looksLikeGltf(json));
  EXPECT_EQ(error(replaced(json, "AAAA", "AA!A")), "file: buffer 0 has malformed base64 data");
  EXPECT_EQ(
    error(replaced(json, "data:application/octet-stream;base64,", "mesh.bin?")).substr(0, 39),
    "file: buffer 0 is 'mesh.bin?AAAAAAAAAAA");
  scan::test::expectErrorOrModelWhenDamaged(scan::parseGltf, json);
}

TEST(Gltf, AsksForBuffersInFilesOfTheirOwn)
{
  std::string json = "{'buffers':[{'uri':'a b.bin','byteLength':36}],'bufferViews':[{'buffer':0,"
                     "'byteLength':36}],'accessors':[{'bufferView':0,'componentType':5126,'count':3"
                     ",'type':'VEC3'}],'meshes':[{'primitives':[{'attributes':{'POSITION':0,"
                     "'NORMAL':0}}]}],'asset':{'version':'2.0'}}";
  std::replace(json.begin(), json.end(), '\'', '"');
  const std::string buffer = raw<float>({ 0, 0, 0, 1, 0, 0, 0, 2, 0 });
  std::string asked;
  const auto read = [&](const std::string& bytes)
  {
    const auto readBuffer = [&](const std::string& uri)
    {
      asked += uri;
      return std::span<const char>(bytes);
    };
    scan::Execution execution(1);
    return scan::parseGltfScene(json, "file", { .readBuffer = readBuffer }, execution);
  };
  EXPECT_EQ(read(buffer).points, (std::vector<Vec3>{ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 2, 0 } }));
  EXPECT_EQ(asked, "a b.bin"); // once
  EXPECT_THROW(read(buffer.substr(1)), scan::Error);
  EXPECT_EQ(error(json),
    "file: buffer 0 is 'a b.bin', which is not read; save as .glb or with embedded buffers");
}

TEST(Gltf, ReadsQuantizedCoordinatesWithAStride)
{
  std::string json =
    replaced(kJson, "{'buffer':0,'byteLength':96}", "{'buffer':0,'byteLength':96,'byteStride':12}");
  json = replaced(json, "'componentType':5126,'count':4,'type':'VEC3','min'",
    "'componentType':5123,'count':4,'type':'VEC3','min'");
  json = replaced(json, "'scene'", "'extensionsRequired':['KHR_mesh_quantization'],'scene'");
  const Model model = parse(glb(json, kBuffer));
  EXPECT_EQ(model.points[1], (Vec3{ 0, 16256, 0 })); // the halves of the float 1, and zero
}

TEST(Gltf, RefusesWhatItDoesNotRead)
{
  EXPECT_EQ(
    error(squareWith("'scene':0", "'extensionsRequired':['KHR_draco_mesh_compression'],'scene':0")),
    "file: the file needs the extension 'KHR_draco_mesh_compression', which is not read; export it "
    "without compression");
  EXPECT_EQ(error(squareWith("'count':4,", "'count':4,'sparse':{},")),
    "file: accessor 0 is sparse, which is not read; export without sparse accessors");
  EXPECT_EQ(error(squareWith("'accessors':[{'bufferView':0,", "'accessors':[{")),
    "file: accessor 0 has no data; the file is compressed or incomplete");
  EXPECT_EQ(
    error(squareWith("'2.0'", "'1.0'")), "file: glTF of version '1.0'; only version 2 is read");
  EXPECT_EQ(error(replaced(square(), std::string("glTF\2"), std::string("glTF\1"))),
    "file: GLB of version 1; only version 2 is read");
  EXPECT_EQ(error(std::string("glTF\2\0\0\0\2\0\0\0JSON", 16)),
    "file: the header announces 2 bytes, but the file has 16; it is truncated or malformed");
}

TEST(Gltf, RefusesDataOutOfBounds)
{
  EXPECT_NE(error(squareWith("'count':4,", "'count':9,")).find("accessor 0 announces 9 elements"),
    std::string::npos);
  EXPECT_NE(error(squareWith("'count':4,", "'count':18446744073709551615,")).find("accessor 0"),
    std::string::npos);
  EXPECT_NE(error(squareWith("'byteLength':96", "'byteLength':960")).find("buffer view 0 reaches"),
    std::string::npos);
  EXPECT_NE(error(squareWith("'byteLength':128", "'byteLength':129"))
              .find("buffer 0 announces 129 bytes, but has 128"),
    std::string::npos);
  EXPECT_NE(error(squareWith("'count':4,'type':'VEC3','min'", "'count':3,'type':'VEC3','min'"))
              .find("accessor 3 refers to vertex 3, but there are 3, counted from 0"),
    std::string::npos);
  EXPECT_NE(
    error(squareWith("'indices':3", "'indices':7")).find("entry 7 of 'accessors', but there are 5"),
    std::string::npos);
  EXPECT_NE(error(squareWith("'indices':3", "'indices':-3")).find("'indices' is not a number"),
    std::string::npos);
  EXPECT_NE(
    error(squareWith("'indices':3", "'indices':0")).find("accessor 0 does not hold indices"),
    std::string::npos);
}

TEST(Gltf, RefusesNodesThatContainThemselves)
{
  EXPECT_EQ(error(squareWith("{'mesh':0}", "{'mesh':0,'children':[0]}")),
    "file: node 0 is in the scene twice or contains itself; the file is malformed");
  EXPECT_NE(error(squareWith("'nodes':[{'mesh':0}]", "'nodes':[{'children':[7]}]"))
              .find("entry 7 of 'nodes'"),
    std::string::npos);
}

TEST(Gltf, RefusesDeepJsonAndCopiesWithoutEnd)
{
  EXPECT_NE(error(std::string(200, '[') + std::string(200, ']')).find("nests deeper than 100"),
    std::string::npos);
  EXPECT_NE(error("{\"a\":" + std::string(1000000, '[')).find("nests deeper"), std::string::npos);
  std::string small = "{\"a\":[{}";
  for (int i = 0; i < 500000; ++i)
  {
    small += ",{}";
  }
  EXPECT_NE(error(small + "]}").find("too many small values"), std::string::npos);
  std::string nodes = "'nodes':[0";
  std::string list = "'nodes':[{'mesh':0}";
  for (int i = 1; i < 1000; ++i)
  {
    nodes += ',';
    nodes += std::to_string(i);
    list += ",{'mesh':0}";
  }
  std::string primitives = "'count':20000,'type':'VEC3','min'";
  std::string json = replaced(kJson, "'nodes':[0", nodes);
  json = replaced(json, "'nodes':[{'mesh':0}", list);
  json = replaced(json, "'count':4,'type':'VEC3','min'", primitives);
  json = replaced(json, "'byteLength':96}", "'byteLength':240000}");
  json = replaced(json, "'byteLength':128", "'byteLength':240000");
  const auto readSmall =
    [](std::span<const char> bytes, std::string_view name, scan::Execution& execution)
  { return scan::parseGltfScene(bytes, name, { .largest = 36e6 }, execution); };
  EXPECT_NE(scan::test::parseError(readSmall, glb(json, kBuffer + std::string(240000, '\0')))
              .find("shows its meshes so often that they take 540 MB"),
    std::string::npos);
}

TEST(Gltf, RefusesScenesWithoutAModel)
{
  EXPECT_NE(
    error(squareWith("{'mesh':0}", "{}")).find("no points and no triangles"), std::string::npos);
  EXPECT_NE(error("{}").find("does not say asset.version"), std::string::npos);
  EXPECT_NE(error("{\"asset\"").find("malformed JSON"), std::string::npos);
  EXPECT_NE(error("").find("malformed JSON"), std::string::npos);
}

TEST(Gltf, CountsUnusableCoordinates)
{
  EXPECT_EQ(error(squareWith("{'mesh':0}", "{'mesh':0,'scale':[1e60,1,1]}")),
    "file: 2 of 4 points have coordinates that are not finite or exceed 1e50; remove them");
}

TEST(Gltf, IsRecognised)
{
  EXPECT_TRUE(scan::looksLikeGltf(square()));
  EXPECT_FALSE(scan::looksLikeGltf(std::string("{ \"name\": 1 }")));
  EXPECT_FALSE(scan::looksLikeGltf(std::string("solid \"asset\"")));
}

TEST(Gltf, SurvivesDamage)
{
  scan::test::expectErrorOrModelWhenDamaged(scan::parseGltf, square());
}

TEST(Gltf, AgreesWithAssimpOnARealFile)
{
  const std::filesystem::path path = SCAN_SHARED_DIR "/data/05_meshes/trimesh/Duck.glb";
  if (!std::filesystem::exists(path))
  {
    GTEST_SKIP() << path << " is missing";
  }
  const scan::MappedFile file(path.string());
  scan::Execution execution(1);
  const Model model = scan::parseGltf(file.bytes(), "Duck.glb", execution);
  EXPECT_EQ(model.points.size(), 2399U); // as "assimp info" says
  EXPECT_EQ(model.triangles.size(), 4212U);
  EXPECT_EQ(model.normals.size(), model.points.size());
  Vec3 low = model.points[0];
  Vec3 high = low;
  for (const Vec3& p : model.points)
  {
    low = { std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z) };
    high = { std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z) };
  }
  EXPECT_NEAR(low.x, -0.692985, 1e-6);
  EXPECT_NEAR(low.y, 0.099294, 1e-6);
  EXPECT_NEAR(high.x, 0.961799, 1e-6);
  EXPECT_NEAR(high.z, 0.539252, 1e-6);
}
