// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Colours and normals of points, there and back, and as other programs see them.
#include "readers/obj.h"
#include "readers/ply.h"
#include "readers/points_text.h"
#include "tests/readers/parsing.h"
#include "tests/writers/models.h"
#include "tests/writers/other_programs.h"
#include "tests/writers/written.h"
#include "writers/obj.h"
#include "writers/xyz.h"

#include <random>
#include <sstream>

namespace
{

using scan::Encoding;
using scan::Model;
using scan::Vec3;
using scan::test::modelBytes;
using scan::test::plyFormat;

Vec3 unit(const Vec3& v)
{
  return v * (1.0 / std::sqrt(dot(v, v)));
}

/// The model with normals of all directions; one is 0.
Model shaded(Model model)
{
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  for (std::size_t i = 0; i < model.points.size(); ++i)
  {
    model.normals.push_back(unit({ normal(random), normal(random), normal(random) }));
  }
  model.normals.back() = {};
  return model;
}

/// The model with normals that float32 holds.
Model coarselyShaded(Model model)
{
  model.normals.assign(model.points.size(), { 0, -1, 0 });
  return model;
}

void expectSameAttributes(const Model& model, const Model& expected)
{
  EXPECT_EQ(model.points, expected.points);
  EXPECT_EQ(model.triangles, expected.triangles);
  EXPECT_EQ(model.colors, expected.colors);
  ASSERT_EQ(model.normals.size(), expected.normals.size());
  for (std::size_t i = 0; i < model.normals.size(); ++i)
  {
    const Vec3 difference = model.normals[i] - expected.normals[i];
    ASSERT_LE(std::sqrt(dot(difference, difference)), 1e-15) << i;
  }
}

/// With neither, one of them and both; of many points, so that all colours of 0 to 255 are there.
std::vector<Model> models()
{
  using namespace scan::test;
  std::vector<Model> models;
  for (const Model& model :
    { grid(40, 30, true), grid(20, 20, false), nonManifold(), threePoints() })
  {
    models.insert(models.end(), { model, colored(model), shaded(model), colored(shaded(model)) });
  }
  return models;
}

std::string readWithPython(const Model& model, Encoding encoding)
{
  const scan::test::TemporaryFolder folder;
  scan::test::writeModel(folder.file("a.ply"), model, plyFormat(encoding));
  return scan::test::outputOf(
    "/usr/bin/python3 " SCAN_DATA_DIR "/../tests/writers/read_ply.py " + folder.file("a.ply"));
}

/// What readWithPython must find.
std::string listOf(const Model& model)
{
  std::ostringstream text;
  text.precision(17);
  text << "x y z" << (model.normals.empty() ? "" : " nx ny nz")
       << (model.colors.empty() ? "" : " red green blue") << "\n";
  for (std::size_t i = 0; i < model.points.size(); ++i)
  {
    const Vec3& p = model.points[i];
    text << p.x << " " << p.y << " " << p.z;
    if (!model.normals.empty())
    {
      const Vec3& n = model.normals[i];
      text << " " << n.x << " " << n.y << " " << n.z;
    }
    if (!model.colors.empty())
    {
      const auto& [red, green, blue] = model.colors[i];
      text << " " << int{ red } << " " << int{ green } << " " << int{ blue };
    }
    text << "\n";
  }
  for (const auto& [a, b, c] : model.triangles)
  {
    text << a << " " << b << " " << c << "\n";
  }
  return text.str();
}

/// The numbers of a text, whose words must be the same else.
void expectSameNumbers(const std::string& text, const std::string& expected)
{
  std::istringstream found(text);
  std::istringstream wanted(expected);
  std::string a;
  std::string b;
  std::size_t words = 0;
  while (wanted >> b)
  {
    ASSERT_TRUE(found >> a) << words;
    char* end = nullptr;
    const double value = std::strtod(b.c_str(), &end);
    ASSERT_TRUE(*end == 0 ? std::strtod(a.c_str(), nullptr) == value : a == b) << a << " " << b;
    ++words;
  }
  EXPECT_FALSE(found >> a) << a;
}

} // namespace

TEST(WrittenAttributes, ReadBackFromPly)
{
  for (const Model& model : models())
  {
    for (const Encoding encoding : { Encoding::binary, Encoding::ascii })
    {
      const std::string bytes = modelBytes(model, plyFormat(encoding));
      expectSameAttributes(scan::test::parse(scan::parsePly, bytes), model);
    }
  }
}

TEST(WrittenAttributes, ReadBackFromObj)
{
  for (const Model& model : models())
  {
    const std::string bytes = modelBytes(model, scan::writeObj);
    expectSameAttributes(scan::test::parse(scan::parseObj, bytes), model);
  }
}

TEST(WrittenAttributes, ReadBackFromText)
{
  for (Model model : models())
  {
    model.triangles.clear();
    const std::string bytes = modelBytes(model, scan::writeXyz);
    expectSameAttributes(scan::test::parse(scan::parsePointsText, bytes, 3), model);
  }
}

TEST(WrittenAttributes, GiveTheseBytes)
{
  Model model = scan::test::oneTriangle();
  model.colors = { { 0, 128, 255 }, { 1, 2, 3 }, { 254, 100, 0 } };
  model.normals = { { 0, 0, 1 }, { 0.6, -0.8, 0 }, { 0, 0, 0 } };
  EXPECT_EQ(modelBytes(model, plyFormat(Encoding::ascii)),
    "ply\nformat ascii 1.0\ncomment PLY by Scanwrap\nelement vertex 3\n"
    "property double x\nproperty double y\nproperty double z\n"
    "property double nx\nproperty double ny\nproperty double nz\n"
    "property uchar red\nproperty uchar green\nproperty uchar blue\n"
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0 0 0 1 0 128 255\n2.5 0 0 0.6 -0.8 0 1 2 3\n0 -0.125 1e-07 0 0 0 254 100 0\n3 0 1 2\n");
  EXPECT_EQ(modelBytes(model, scan::writeObj),
    "# OBJ by Scanwrap\nv 0 0 0 0.0000 0.5020 1.0000\nv 2.5 0 0 0.0040 0.0079 0.0118\n"
    "v 0 -0.125 1e-07 0.9961 0.3922 0.0000\nvn 0 0 1\nvn 0.6 -0.8 0\nvn 0 0 0\n"
    "f 1//1 2//2 3//3\n");
}

TEST(WrittenAttributes, KeepFloatCoordinatesOnlyBesideFloatNormals)
{
  const Model model = scan::test::grid(4, 4, true);
  const auto head = [](const Model& written)
  { return modelBytes(written, plyFormat(Encoding::binary)).substr(0, 400); };
  EXPECT_NE(head(coarselyShaded(model)).find("property float nx"), std::string::npos);
  EXPECT_NE(head(coarselyShaded(model)).find("property float x"), std::string::npos);
  EXPECT_NE(head(shaded(model)).find("property double nx"), std::string::npos);
  EXPECT_NE(head(shaded(model)).find("property double x"), std::string::npos);
}

TEST(WrittenAttributes, HoldTheLongestNumbers)
{
  Model model;
  const double longest = -1.2345678901234567e-105;
  model.points = { { longest, longest, longest } };
  model.normals = { unit({ -1.2345678901234567e-5, -2.2345678901234567e-5, -1.1 }) };
  model.colors = { { 100, 200, 255 } };
  for (const Encoding encoding : { Encoding::binary, Encoding::ascii })
  {
    expectSameAttributes(
      scan::test::parse(scan::parsePly, modelBytes(model, plyFormat(encoding))), model);
  }
  expectSameAttributes(scan::test::parse(scan::parseObj, modelBytes(model, scan::writeObj)), model);
}

TEST(WrittenAttributes, AreThereForPython)
{
  if (!scan::test::isInstalled("/usr/bin/python3 --version"))
  {
    GTEST_SKIP() << "/usr/bin/python3 is missing: nothing reads the files back";
  }
  for (const Model& model : models())
  {
    for (const Encoding encoding : { Encoding::binary, Encoding::ascii })
    {
      expectSameNumbers(readWithPython(model, encoding), listOf(model));
    }
  }
}

TEST(WrittenAttributes, AreThereForAssimp)
{
  if (!scan::test::hasAssimp())
  {
    GTEST_SKIP() << "assimp is missing: nothing reads the files back";
  }
  using namespace scan::test;
  // colours differ from vertex to vertex, or assimp could mix them up unseen
  const Model model = colored(shaded(grid(12, 10, true)));
  const TemporaryFolder folder;
  writeModel(folder.file("a.ply"), model, plyFormat(Encoding::binary));
  writeModel(folder.file("b.obj"), model, scan::writeObj);
  for (const std::string name : { "a.ply", "b.obj" })
  {
    const std::string ply = folder.file(name + ".assimp.ply");
    const std::string output =
      outputOf("assimp export " + folder.file(name) + " " + ply + " -fply");
    ASSERT_NE(output.find("wrote output file"), std::string::npos) << output;
    const Model read = parse(scan::parsePly, contentOf(ply));
    EXPECT_EQ(read.triangles.size(), model.triangles.size()) << name;
    ASSERT_EQ(read.colors.size(), read.points.size()) << name;
    ASSERT_EQ(read.normals.size(), read.points.size()) << name;
    // assimp may have the vertices in another order, and some more than once
    for (std::size_t i = 0; i < read.points.size(); ++i)
    {
      const auto isNear = [](const Vec3& a, const Vec3& b)
      { return std::sqrt(dot(a - b, a - b)) < 1e-4; };
      const auto found = std::find_if(model.points.begin(), model.points.end(),
        [&](const Vec3& p) { return isNear(p, read.points[i]); });
      ASSERT_NE(found, model.points.end()) << name << i;
      const auto at = static_cast<std::size_t>(found - model.points.begin());
      EXPECT_EQ(read.colors[i], model.colors[at]) << name << i;
      EXPECT_TRUE(isNear(read.normals[i], model.normals[at])) << name << i;
    }
  }
}
