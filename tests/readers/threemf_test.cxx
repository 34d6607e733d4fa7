// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/threemf.h"

#include "readers/mapped_file.h"
#include "tests/readers/damage.h"

#include <zlib.h>

#include <cstdint>
#include <filesystem>
#include <map>

namespace
{

using scan::Model;
using scan::Triangle;
using scan::Vec3;

using Parts = std::map<std::string, std::string>;

std::string raw16(std::size_t value)
{
  return { static_cast<char>(value & 255U), static_cast<char>(value >> 8U & 255U) };
}

std::string raw32(std::size_t value)
{
  return raw16(value & 0xffffU) + raw16(value >> 16U);
}

std::string deflated(std::string text)
{
  std::string packed(compressBound(text.size()) + 16, '\0');
  z_stream stream = {};
  deflateInit2(&stream, 9, Z_DEFLATED, -15, 9, Z_DEFAULT_STRATEGY);
  stream.next_in = reinterpret_cast<Bytef*>(text.data());
  stream.avail_in = static_cast<uInt>(text.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  deflate(&stream, Z_FINISH);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  return packed;
}

std::string zip(const Parts& parts, bool isDeflated = true)
{
  std::string file;
  std::string directory;
  for (const auto& [name, text] : parts)
  {
    const std::string packed = isDeflated ? deflated(text) : text;
    const std::size_t sum = crc32_z(0, reinterpret_cast<const Bytef*>(text.data()), text.size());
    const std::string header = raw16(20) + raw16(0) + raw16(isDeflated ? 8 : 0) + raw32(0) +
      raw32(sum) + raw32(packed.size()) + raw32(text.size()) + raw16(name.size());
    directory += "PK\1\2" + raw16(20) + header + std::string(12, '\0') + raw32(file.size()) + name;
    file += "PK\3\4" + header + raw16(0) + name + packed;
  }
  return file + directory + "PK\5\6" + raw32(0) + raw16(parts.size()) + raw16(parts.size()) +
    raw32(directory.size()) + raw32(file.size()) + raw16(0);
}

const std::string kRels =
  "<Relationships><Relationship Target='/3D/my.model' Id='r'"
  " Type='http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel'/></Relationships>";

std::string file(const std::string& xml, bool isDeflated = true)
{
  return zip(
    { { "_rels/.rels", kRels }, { "3D/my.model", xml }, { "3D/a.model", "no xml" } }, isDeflated);
}

std::string model(
  const std::string& resources, const std::string& items, const std::string& unit = "inch")
{
  return "<?xml version=\"1.0\"?>\n<model unit=\"" + unit + "\">\n<resources>\n" + resources +
    "</resources>\n<build>" + items + "</build>\n</model>\n";
}

const std::string kMesh =
  "<mesh><vertices><!-- > < a \" comment --><vertex x=\"0\" y='0' z=\" 0 \"/>\n"
  "<vertex x=\"1.5\" y=\"0\" z=\"0\"></vertex><vertex z=\"0\" y=\"2e0\" x=\"-.25\" a:x=\"7\"/>\n"
  "</vertices><triangles><triangle v1=\"0\" v2=\"1\" v3=\"2\" pid=\"1\"/></triangles></mesh>";

const std::string kObject = "<object id=\"4\" type=\"model\">" + kMesh + "</object>\n";
const std::string kItem = "<item objectid=\"4\"/>";

const std::vector<Vec3> kPoints = { { 0, 0, 0 }, { 1.5, 0, 0 }, { -0.25, 2, 0 } };

Model parse(const std::string& bytes)
{
  return scan::test::parse(scan::parseThreemf, bytes);
}

std::string error(const std::string& bytes)
{
  return scan::test::parseError(scan::parseThreemf, bytes);
}

} // namespace

TEST(Threemf, ReadsStoredAndDeflatedParts)
{
  for (const bool isDeflated : { false, true })
  {
    const Model read = parse(file(model(kObject, kItem), isDeflated));
    EXPECT_EQ(read.points, kPoints);
    EXPECT_EQ(read.triangles, (std::vector<Triangle>{ { 0, 1, 2 } }));
    EXPECT_EQ(read.millimetresPerUnit, 25.4);
  }
}

TEST(Threemf, KnowsEveryUnit)
{
  const auto unit = [](const char* name)
  { return parse(file(model(kObject, kItem, name))).millimetresPerUnit; };
  EXPECT_EQ(unit("micron"), 0.001);
  EXPECT_EQ(unit("millimeter"), 1.0);
  EXPECT_EQ(unit("centimeter"), 10.0);
  EXPECT_EQ(unit("foot"), 304.8);
  EXPECT_EQ(unit("meter"), 1000.0);
  EXPECT_NE(
    error(file(model(kObject, kItem, "mile"))).find("my.model', line 2: unknown unit 'mile'"),
    std::string::npos);
}

TEST(Threemf, PlacesItemsAndComponents)
{
  const std::string assembly =
    "<object id=\"5\"><components>"
    "<component objectid=\"4\" transform=\"0 1 0 -1 0 0 0 0 1 10 0 0\"/>"
    "<component objectid=\"4\" transform=\"-1 0 0 0 1 0 0 0 1 0 0 0\"/></components></object>";
  const Model read = parse(file(model(
    kObject + assembly, "<item objectid=\"5\" transform=\"2 0 0 0 2 0 0 0 2 0 0 100\"/>" + kItem)));
  ASSERT_EQ(read.points.size(), 9U);
  EXPECT_EQ(read.points[1], (Vec3{ 20, 3, 100 })); // x became y
  EXPECT_EQ(read.points[2], (Vec3{ 16, -0.5, 100 }));
  EXPECT_EQ(read.points[4], (Vec3{ -3, 0, 100 }));
  EXPECT_EQ(read.points[7], kPoints[1]);
  EXPECT_EQ(read.triangles, (std::vector<Triangle>{ { 0, 1, 2 }, { 4, 3, 5 }, { 6, 7, 8 } }));
}

TEST(Threemf, FollowsComponentsIntoOtherParts)
{
  const std::string assembly = "<object id=\"1\"><components>"
                               "<component p:path=\"/3D/o/b.model\" objectid=\"4\"/></components>"
                               "</object>";
  const Parts parts = { { "_rels/.rels", kRels }, { "3D/o/b.model", model(kObject, "") },
    { "3D/my.model", model(assembly, "<item objectid=\"1\"/>", "meter") } };
  const Model read = parse(zip(parts));
  EXPECT_EQ(read.points, kPoints);
  EXPECT_EQ(read.millimetresPerUnit, 1000.0);
}

TEST(Threemf, GivesAllMeshesWhenNothingIsBuilt)
{
  EXPECT_EQ(parse(file(model(kObject, ""))).points, kPoints);
}

TEST(Threemf, LeavesOutWhatExtensionsSay)
{
  const std::string slices =
    "<s:slicestack id=\"9\"><s:slice><s:vertices><s:vertex x=\"1\" y=\"1\"/></s:vertices></s:slice>"
    "</s:slicestack><basematerials><vertex/></basematerials>";
  EXPECT_EQ(parse(file(model(slices + kObject, kItem))).points, kPoints);
}

TEST(Threemf, NamesTheLineOfMalformedText)
{
  const auto errorWith = [](const std::string& from, const std::string& to)
  {
    std::string text = model(kObject, kItem);
    text.replace(text.find(from), from.size(), to);
    return error(file(text));
  };
  EXPECT_EQ(errorWith("v3=\"2\"", "v3=\"3\""),
    "file: part '3D/my.model', line 6: a triangle refers to vertex 3, but there are 3, counted "
    "from 0");
  EXPECT_EQ(
    errorWith("1.5", "1,5"), "file: part '3D/my.model', line 5: expected a number, found '1,5'");
  EXPECT_EQ(errorWith("v1=\"0\"", "v1=\"-1\""),
    "file: part '3D/my.model', line 6: expected an index, found '-1'");
  EXPECT_EQ(errorWith("x=\"1.5\" ", ""),
    "file: part '3D/my.model', line 5: the tag 'vertex' lacks the attribute 'x'");
  EXPECT_NE(errorWith("x=\"1.5\"", "x=1.5").find("malformed attribute in the tag 'vertex'"),
    std::string::npos);
  EXPECT_NE(errorWith("<resources>", "<!DOCTYPE a [<!ENTITY b 'c'>]>").find("document type"),
    std::string::npos);
  EXPECT_NE(errorWith("</model>", "").find("the document ends too early"), std::string::npos);
  EXPECT_NE(errorWith("</model>", "</model").find("ends inside a tag"), std::string::npos);
  EXPECT_NE(
    errorWith("</build>", "<!-- </build>").find("ends inside a comment"), std::string::npos);
  EXPECT_NE(
    errorWith("objectid=\"4\"", "objectid=\"5\"").find("has no object 5"), std::string::npos);
  EXPECT_NE(errorWith("objectid=\"4\"", "objectid=\"4\" transform=\"1 0 0\"")
              .find("expected a transform of 12 numbers, found '1 0 0'"),
    std::string::npos);
  EXPECT_NE(error(file(model(kObject + kObject, kItem))).find("object 4 is there twice"),
    std::string::npos);
  EXPECT_NE(error(file("<a/>")).find("no element 'model'"), std::string::npos);
  EXPECT_NE(error(file(model("", ""))).find("no mesh found"), std::string::npos);
}

TEST(Threemf, RefusesDamagedArchives)
{
  const std::string good = file(model(kObject, kItem), false);
  EXPECT_NE(error(good.substr(0, good.size() - 23)).find("no directory of a zip archive"),
    std::string::npos);
  EXPECT_NE(error("PK").find("too short"), std::string::npos);
  std::string changed = good;
  changed[changed.find("1.5")] = '2';
  EXPECT_NE(error(changed).find("the part '3D/my.model' is damaged: it does not unpack"),
    std::string::npos);
  std::string encrypted = good;
  encrypted[encrypted.find("PK\1\2", encrypted.find("PK\1\2") + 1) + 8] = 1;
  EXPECT_NE(error(encrypted).find("is encrypted or packed by a method"), std::string::npos);
  EXPECT_NE(error(zip({ { "word/document.xml", "<a/>" } })).find("no 3D model"), std::string::npos);
  EXPECT_NE(
    error(zip({ { "_rels/.rels", kRels } })).find("has no part '3D/my.model'"), std::string::npos);
}

TEST(Threemf, RefusesObjectsThatContainThemselves)
{
  const std::string self =
    "<object id=\"5\"><components><component objectid=\"5\"/></components></object>";
  EXPECT_NE(error(file(model(self, "<item objectid=\"5\"/>"))).find("object 5 contains itself"),
    std::string::npos);
  // a chain, whose objects are built one by one before the last
  std::string chain = kObject;
  std::string items;
  for (int i = 5; i < 50000; ++i)
  {
    chain += "<object id=\"" + std::to_string(i) + "\"><components><component objectid=\"" +
      std::to_string(i - 1) + "\"/></components></object>\n";
    items += "<item objectid=\"" + std::to_string(i) + "\"/>";
  }
  EXPECT_NE(
    error(file(model(chain, items))).find("nest deeper than 100 levels"), std::string::npos);
}

TEST(Threemf, RefusesWhatGrowsWithoutEnd)
{
  std::string doubling = kObject;
  for (int i = 5; i < 70; ++i)
  {
    const std::string use = "<component objectid=\"" + std::to_string(i - 1) + "\"/>";
    doubling.append("<object id=\"").append(std::to_string(i)).append("\"><components>");
    doubling.append(use).append(use).append("</components></object>\n");
  }
  EXPECT_NE(
    error(file(model(doubling, "<item objectid=\"69\"/>"))).find("save it with fewer copies"),
    std::string::npos);
  EXPECT_NE(error(file(model(kObject, kItem) + std::string(100000000, ' ')))
              .find("the part '3D/my.model' unpacks to more than 200 times the size"),
    std::string::npos);
  std::string deep = "<model>";
  for (int i = 0; i < 1000; ++i)
  {
    deep += "<a>";
  }
  EXPECT_NE(error(file(deep)).find("nest deeper than 100 levels"), std::string::npos);
  EXPECT_NE(error(file("<model " + std::string(2000000, ' '))).find("a tag of more than 1 MB"),
    std::string::npos);
  std::string vertices;
  for (int i = 0; i < 4000000; ++i)
  {
    vertices += "<vertex x=\"0\" y=\"0\" z=\"0\"/>";
  }
  const std::string mesh =
    "<object id=\"1\"><mesh><vertices>" + vertices + "</vertices></mesh></object>";
  EXPECT_NE(error(file(model(mesh, ""))).find("far more memory than a file of this size"),
    std::string::npos);
}

TEST(Threemf, CountsUnusableCoordinates)
{
  EXPECT_EQ(
    error(file(model(kObject, "<item objectid=\"4\" transform=\"1e60 0 0 0 1 0 0 0 1 0 0 0\"/>"))),
    "file: 2 of 3 points have coordinates that are not finite or exceed 1e50; remove them");
}

TEST(Threemf, IsRecognised)
{
  EXPECT_TRUE(scan::looksLikeThreemf(file(model(kObject, kItem))));
  EXPECT_FALSE(scan::looksLikeThreemf(zip({ { "word/document.xml", "<a/>" } })));
  EXPECT_FALSE(scan::looksLikeThreemf(std::string("PK\3\4")));
}

TEST(Threemf, SurvivesDamage)
{
  scan::test::expectErrorOrModelWhenDamaged(scan::parseThreemf, file(model(kObject, kItem), false));
  scan::test::expectErrorOrModelWhenDamaged(scan::parseThreemf, file(model(kObject, kItem)));
}

TEST(Threemf, ReadsRealFiles)
{
  const std::filesystem::path folder = SCAN_SHARED_DIR "/data";
  const auto read = [&](const char* name)
  {
    const scan::MappedFile bytes((folder / name).string());
    scan::Execution execution(1);
    return scan::parseThreemf(bytes.bytes(), name, execution);
  };
  if (!std::filesystem::exists(folder / "05_meshes/trimesh/counterXP.3MF"))
  {
    GTEST_SKIP() << folder << " is missing";
  }
  const Model counter = read("05_meshes/trimesh/counterXP.3MF");
  const Model part = read("06_cad/trimesh/featuretype.3MF");
  EXPECT_EQ(counter.points.size(), 43276U); // 11 components of 4 meshes
  EXPECT_EQ(counter.triangles.size(), 83750U);
  EXPECT_EQ(part.points.size(), 1092U); // as "assimp info" says
  EXPECT_EQ(part.triangles.size(), 2208U);
  double lowest = part.points[0].y;
  double highest = part.points[0].z;
  for (const Vec3& p : part.points)
  {
    lowest = std::min(lowest, p.y);
    highest = std::max(highest, p.z);
  }
  EXPECT_NEAR(lowest, -1.25, 1e-6);
  EXPECT_NEAR(highest, 1.375, 1e-6);
}
