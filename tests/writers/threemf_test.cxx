// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/threemf.h"

#include "readers/threemf.h"
#include "tests/readers/parsing.h"
#include "tests/writers/models.h"
#include "tests/writers/other_programs.h"

#include <gtest/gtest.h>

namespace
{

const auto kWrite = scan::test::aroundItsMiddle(scan::writeThreemf);

using scan::Model;
using scan::Vec3;
using scan::test::grid;
using scan::test::moved;

std::string bytesOf(const Model& model, unsigned threads = 1)
{
  return scan::test::modelBytes(model, kWrite, threads);
}

/// The part with the model, by the program unzip; empty without it.
std::string modelPartOf(const Model& model)
{
  const scan::test::TemporaryFolder folder;
  scan::test::setContent(folder.file("m.3mf"), bytesOf(model));
  const std::string command = "unzip -tq " + folder.file("m.3mf") +
    " >/dev/null 2>&1 && unzip -p " + folder.file("m.3mf") + " 3D/3dmodel.model >" +
    folder.file("xml");
  return std::system(command.c_str()) == 0 ? scan::test::contentOf(folder.file("xml")) : "";
}

Model triangle()
{
  Model model;
  model.points = { { 0, 0, 0 }, { 1.5, -1e-7, 0 }, { 0.1, 1e9, 3 } };
  model.triangles = { { 0, 1, 2 } };
  return model;
}

void expectSameInAssimp(const Model& model)
{
  const scan::test::TemporaryFolder folder;
  scan::test::setContent(folder.file("model.3mf"), bytesOf(model));
  scan::test::expectSame(scan::test::readWithAssimp(folder.file("model.3mf")), model);
}

} // namespace

TEST(Threemf, HasThisModelPart)
{
  if (std::system("unzip -v >/dev/null 2>&1") != 0)
  {
    GTEST_SKIP() << "the program unzip is missing";
  }
  const std::string head =
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<model unit=\"millimeter\" xml:lang=\"en-US\""
    " xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\">\n"
    "<metadata name=\"Application\">Scanwrap</metadata>\n"
    "<resources>\n<object id=\"1\" type=\"model\">\n<mesh>\n<vertices>\n"
    "<vertex x=\"0\" y=\"0\" z=\"0\"/>\n"
    "<vertex x=\"1.5\" y=\"-1e-07\" z=\"0\"/>\n"
    "<vertex x=\"0.1\" y=\"1e+09\" z=\"3\"/>\n"
    "</vertices>\n<triangles>\n<triangle v1=\"0\" v2=\"1\" v3=\"2\"/>\n"
    "</triangles>\n</mesh>\n</object>\n</resources>\n<build>\n";
  EXPECT_EQ(modelPartOf(triangle()), head + "<item objectid=\"1\"/>\n</build>\n</model>\n");
  Model inches = triangle();
  inches.millimetresPerUnit = 25.4;
  EXPECT_NE(modelPartOf(inches).find("unit=\"inch\""), std::string::npos);
  Model miles = triangle();
  miles.millimetresPerUnit = 1609344.0;
  EXPECT_EQ(modelPartOf(miles),
    head +
      "<item objectid=\"1\" transform=\"1609344 0 0 0 1609344 0 0 0 1609344 0 0 0\"/>\n"
      "</build>\n</model>\n");
}

TEST(Threemf, KeepsModelsInAssimp)
{
  if (!scan::test::hasAssimp())
  {
    GTEST_SKIP() << "the program assimp is missing";
  }
  expectSameInAssimp(grid(100, 100, true));
  expectSameInAssimp(moved(grid(20, 20, false), { 100, 200, 300 }));
  expectSameInAssimp(scan::test::nonManifold());
}

TEST(Threemf, ComesBackFromTheReader)
{
  Model model = grid(300, 300, true);
  model.points.push_back({ 1e9, -1e-300, -0.0 });
  model.triangles.push_back({ 0, 1, 90000 });
  model.millimetresPerUnit = 1000.0;
  const Model read = scan::test::parse(scan::parseThreemf, bytesOf(model));
  EXPECT_EQ(read.points, model.points);
  EXPECT_EQ(read.triangles, model.triangles);
  EXPECT_EQ(read.millimetresPerUnit, 1000.0);
}

TEST(Threemf, LeavesLoosePointsOut)
{
  Model model = grid(3, 4, true);
  const Model surface = model;
  model.points.insert(model.points.begin(), { 1e30, 0, 0 });
  for (scan::Triangle& t : model.triangles)
  {
    t = { t[0] + 1, t[1] + 1, t[2] + 1 };
  }
  const Model read = scan::test::parse(scan::parseThreemf,
    scan::test::modelBytes(model,
      [](const Model& m, scan::OutputFile& file, scan::Execution& run)
      { scan::writeThreemf(m, {}, file, run); }));
  EXPECT_EQ(read.points, surface.points);
  EXPECT_EQ(read.triangles, surface.triangles);
}

TEST(Threemf, StoresWhatIsFarAwayFromItsMiddleOn)
{
  for (const double unit : { 1000.0, 7.0 }) // with a name, and without
  {
    Model model = moved(grid(30, 30, true), { 665187.522077, -5648349.895035, 1.2e10 });
    model.millimetresPerUnit = unit;
    const Model read = scan::test::parse(scan::parseThreemf, bytesOf(model));
    ASSERT_EQ(read.points.size(), model.points.size());
    for (std::size_t i = 0; i < read.points.size(); ++i)
    {
      const Vec3 off =
        read.points[i] * read.millimetresPerUnit - model.points[i] * model.millimetresPerUnit;
      ASSERT_LT(std::sqrt(dot(off, off)), 1e-5 * unit) << i;
    }
    EXPECT_EQ(modelPartOf(model).find("<vertex x=\"665"), std::string::npos);
  }
}

TEST(Threemf, HasTheSameBytesOnAnyNumberOfThreads)
{
  const Model model = grid(250, 250, true);
  const std::string bytes = bytesOf(model, 1);
  EXPECT_EQ(bytesOf(model, 4), bytes);
  EXPECT_TRUE(bytes.starts_with("PK\3\4"));
}

TEST(Threemf, RefusesWhatItCannotHold)
{
  const auto errorOf = [](const Model& model) { return scan::test::writeMessage(model, kWrite); };
  EXPECT_NE(errorOf({}).find("no triangles to write; 3MF holds surfaces"), std::string::npos);
  Model model = triangle();
  model.triangles.push_back({ 2, 1, 2 });
  EXPECT_NE(
    errorOf(model).find("triangle 1, counted from 0, uses a point twice"), std::string::npos);
  model = triangle();
  model.points[0].y = -1.1e9;
  EXPECT_EQ(scan::test::writeError(model, kWrite), scan::ErrorCode::limit);
}

TEST(Threemf, StopsWhenCancelled)
{
  scan::test::expectCancels(grid(5, 5, true), kWrite);
}
