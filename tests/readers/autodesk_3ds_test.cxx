// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/autodesk_3ds.h"

#include "tests/readers/damage.h"
#include "tests/readers/temporary_folder.h"

#include <cstdint>
#include <cstdio>

namespace
{

using scan::Triangle;
using scan::Vec3;

template <class Number>
std::string raw(Number value)
{
  return { reinterpret_cast<const char*>(&value), sizeof(value) };
}

std::string chunk(unsigned id, const std::string& content)
{
  return raw(static_cast<std::uint16_t>(id)) + raw(static_cast<std::uint32_t>(content.size() + 6)) +
    content;
}

std::string vertices(const std::vector<Vec3>& points)
{
  std::string content = raw(static_cast<std::uint16_t>(points.size()));
  for (const Vec3& p : points)
  {
    content += raw(static_cast<float>(p.x)) + raw(static_cast<float>(p.y));
    content += raw(static_cast<float>(p.z));
  }
  return chunk(0x4110, content);
}

std::string faces(const std::vector<Triangle>& triangles)
{
  std::string content = raw(static_cast<std::uint16_t>(triangles.size()));
  for (const Triangle& triangle : triangles)
  {
    for (const scan::Index corner : triangle)
    {
      content += raw(static_cast<std::uint16_t>(corner));
    }
    content += raw(std::uint16_t(7));
  }
  return chunk(0x4120, content + chunk(0x4150, std::string(4 * triangles.size(), '\0')));
}

/// Local axes that would move every point if they were applied.
std::string axes()
{
  std::string content;
  for (int i = 0; i < 12; ++i)
  {
    content += raw(static_cast<float>(i % 4 == 0 ? -2 : i));
  }
  return chunk(0x4160, content);
}

std::string object(const std::string& name, const std::string& trimesh)
{
  return chunk(0x4000, name + '\0' + chunk(0x4100, trimesh));
}

std::string file(const std::string& objects)
{
  const std::string light = chunk(0x4000, std::string("lamp") + '\0' + chunk(0x4600, "12345678"));
  return chunk(0x4d4d,
    chunk(0x0002, raw(3U)) +
      chunk(0x3d3d, chunk(0x3d3e, raw(3U)) + chunk(0x0100, raw(1.0F)) + light + objects) +
      chunk(0xb000, chunk(0xb00a, "whatever")));
}

const std::vector<Vec3> kCorners = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 2, 0 }, { 0, 0, 3.5 } };
const std::vector<Triangle> kTetrahedron = { { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 } };

std::string twoObjects()
{
  return file(object("one", vertices(kCorners) + faces(kTetrahedron) + axes()) +
    object("two", faces({ { 0, 1, 2 } }) + vertices({ { 5, 5, 5 }, { 6, 5, 5 }, { 5, 7, 5 } })));
}

scan::Model parse(const std::string& bytes)
{
  return scan::test::parse(scan::parseAutodesk3ds, bytes);
}

std::string error(const std::string& bytes)
{
  return scan::test::parseError(scan::parseAutodesk3ds, bytes);
}

} // namespace

TEST(Autodesk3ds, JoinsTheMeshesInWorldCoordinates)
{
  const scan::Model model = parse(twoObjects());
  std::vector<Vec3> points = kCorners;
  points.insert(points.end(), { { 5, 5, 5 }, { 6, 5, 5 }, { 5, 7, 5 } });
  std::vector<Triangle> triangles = kTetrahedron;
  triangles.push_back({ 4, 5, 6 });
  EXPECT_EQ(model.points, points);
  EXPECT_EQ(model.triangles, triangles);
  EXPECT_EQ(model.millimetresPerUnit, 0.0);
}

TEST(Autodesk3ds, ReadsAMeshWithoutFacesAsAScan)
{
  const scan::Model model = parse(file(object("scan", vertices(kCorners))) + "behind the end");
  EXPECT_EQ(model.points, kCorners);
  EXPECT_TRUE(model.triangles.empty());
}

TEST(Autodesk3ds, AgreesWithAssimp)
{
  if (std::system("assimp version >/dev/null 2>&1") != 0)
  {
    GTEST_SKIP() << "the program assimp is missing";
  }
  const scan::test::TemporaryFolder folder;
  const std::string obj = folder.file("mesh.obj");
  const std::string path = folder.file("mesh.3ds");
  scan::test::setContent(
    obj, "v 0 0 0\nv 1 0 0\nv 0 2 0\nv 0 0 3.5\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
  ASSERT_EQ(std::system(("assimp export " + obj + " " + path + " -f3ds >/dev/null").c_str()), 0);
  const scan::Model model = parse(scan::test::contentOf(path));
  EXPECT_EQ(model.triangles.size(), 4U);
  double volume = 0.0;
  for (const auto& [a, b, c] : model.triangles)
  {
    volume += dot(model.points[a], cross(model.points[b], model.points[c])) / 6.0;
  }
  EXPECT_NEAR(volume, 7.0 / 6.0, 1e-6);
}

TEST(Autodesk3ds, NamesAChunkThatDoesNotFit)
{
  const std::string bytes = file(object("one", vertices(kCorners)));
  EXPECT_EQ(error(bytes.substr(0, 100)),
    "file: byte 0: chunk 4D4D announces " + std::to_string(bytes.size()) +
      " bytes where there are 100; the file is truncated or malformed");
  EXPECT_EQ(error(chunk(0x4d4d, chunk(0x3d3d, raw(std::uint16_t(0x4000)) + raw(2U)))),
    "file: byte 12: chunk 4000 announces 2 bytes where there are 6; the file is truncated or "
    "malformed");
}

TEST(Autodesk3ds, RefusesCountsThatDoNotFit)
{
  EXPECT_NE(error(file(object("a", chunk(0x4110, raw(std::uint16_t(2)) + std::string(23, '\0')))))
              .find("chunk 4110 announces 2 vertices, but has 25 bytes; the file is malformed"),
    std::string::npos);
  EXPECT_NE(error(file(object("a", chunk(0x4120, "\1")))).find("4120 announces 0 faces, but has 1"),
    std::string::npos);
  EXPECT_NE(error(file(chunk(0x4000, "endless"))).find("the name of an object does not end"),
    std::string::npos);
}

TEST(Autodesk3ds, RefusesCornersWithoutAVertex)
{
  const std::string message = error(file(
    object("a", vertices(kCorners)) + object("b", vertices(kCorners) + faces({ { 0, 1, 4 } }))));
  EXPECT_NE(message.find("a face refers to vertex 4 of its mesh, but there are 4, counted from 0"),
    std::string::npos)
    << message;
}

TEST(Autodesk3ds, RefusesFilesWithoutAMesh)
{
  EXPECT_NE(error(file("")).find("no mesh with vertices"), std::string::npos);
  EXPECT_NE(error("MN").find("not a 3D Studio file"), std::string::npos);
  EXPECT_NE(error("").find("not a 3D Studio file"), std::string::npos);
}

TEST(Autodesk3ds, CountsUnusableCoordinates)
{
  EXPECT_NE(
    error(file(object("a", vertices({ { 0, 0, 0 }, { 0, INFINITY, 0 } })))).find("1 of 2 points"),
    std::string::npos);
}

TEST(Autodesk3ds, IsRecognised)
{
  EXPECT_TRUE(scan::looksLikeAutodesk3ds(twoObjects()));
  EXPECT_FALSE(scan::looksLikeAutodesk3ds(std::string("MM\0*\0\0\0\x08\0\x0f\0\0\0\0", 14)));
  EXPECT_FALSE(scan::looksLikeAutodesk3ds(std::string("MM points of a scan")));
  EXPECT_FALSE(scan::looksLikeAutodesk3ds(std::string("MM")));
}

TEST(Autodesk3ds, SurvivesDamage)
{
  scan::test::expectErrorOrModelWhenDamaged(scan::parseAutodesk3ds, twoObjects());
}
