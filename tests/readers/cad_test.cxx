// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/cad.h"

#include "filters/geometry/mesh_checks.h"
#include "readers/mapped_file.h"
#include "tests/readers/cad_parts.h"
#include "tests/readers/damage.h"
#include "tests/readers/parsing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <ostream>

using namespace scan;
using namespace scan::test;

namespace
{

constexpr double kPi = std::numbers::pi;

Model stepOf(std::span<const char> bytes, std::string_view name, Execution& execution)
{
  return parseStep(bytes, name, {}, execution);
}

Model igesOf(std::span<const char> bytes, std::string_view name, Execution& execution)
{
  return parseIges(bytes, name, {}, execution);
}

Model fineStep(const TopoDS_Shape& shape, double deflection)
{
  const std::string bytes = stepBytes(shape);
  Execution execution;
  return parseStep(bytes, "file", { .deflection = deflection }, execution);
}

/// Middles of edges and triangles, at most about `count`.
std::vector<Vec3> middlesOf(const TriMesh& mesh, std::size_t count)
{
  std::vector<Vec3> middles;
  const std::size_t stride = std::max<std::size_t>(1, 4 * mesh.triangles.size() / count);
  for (std::size_t i = 0; i < mesh.triangles.size(); i += stride)
  {
    const auto& [a, b, c] = mesh.triangles[i];
    middles.push_back((mesh.points[a] + mesh.points[b]) * 0.5);
    middles.push_back((mesh.points[b] + mesh.points[c]) * 0.5);
    middles.push_back((mesh.points[c] + mesh.points[a]) * 0.5);
    middles.push_back((mesh.points[a] + mesh.points[b] + mesh.points[c]) * (1.0 / 3.0));
  }
  return middles;
}

/// A closed surface that faces outwards, of that volume within the deflection.
void expectSolid(const Model& model, double volume, double deflection)
{
  const MeshReport report = describeMesh(model);
  EXPECT_TRUE(report.isClosed) << report.boundaryEdges << " open edges";
  EXPECT_TRUE(report.isManifold);
  EXPECT_TRUE(report.isOriented);
  EXPECT_EQ(report.flatTriangles, 0U);
  EXPECT_EQ(report.points, report.pointsUsed);
  EXPECT_NEAR(report.volume.value_or(0.0), volume, deflection * report.area);
  EXPECT_EQ(model.millimetresPerUnit, 1.0);
}

void expectBox(const Model& model, const Vec3& low, const Vec3& high, double tolerance)
{
  const MeshReport report = describeMesh(model);
  EXPECT_NEAR(report.boxMin.x, low.x, tolerance);
  EXPECT_NEAR(report.boxMin.y, low.y, tolerance);
  EXPECT_NEAR(report.boxMin.z, low.z, tolerance);
  EXPECT_NEAR(report.boxMax.x, high.x, tolerance);
  EXPECT_NEAR(report.boxMax.y, high.y, tolerance);
  EXPECT_NEAR(report.boxMax.z, high.z, tolerance);
}

std::string replaced(std::string text, const std::string& from, const std::string& to)
{
  return text.replace(text.find(from), from.size(), to);
}

} // namespace

TEST(CadReader, MakesABoxOfTwelveTriangles)
{
  for (const Model& model : { parse(stepOf, stepBytes(boxPart())),
         parse(igesOf, igesBytes(boxPart(), true)), parse(igesOf, igesBytes(boxPart(), false)) })
  {
    expectSolid(model, 6000.0, 1e-9);
    expectBox(model, { 0, 0, 0 }, { 30, 20, 10 }, 1e-9);
    EXPECT_EQ(model.points.size(), 8U);
    EXPECT_EQ(model.triangles.size(), 12U);
  }
}

TEST(CadReader, ClosesSeamsAndPoles)
{
  const double volume = 4.0 / 3.0 * kPi * 343.0;
  const double deflection = 14.0 * std::sqrt(3.0) / 1000.0;
  for (const Model& model :
    { parse(stepOf, stepBytes(spherePart())), parse(igesOf, igesBytes(spherePart(), true)),
      parse(igesOf, igesBytes(spherePart(), false)) })
  {
    expectSolid(model, volume, deflection);
    expectBox(model, { -6, -5, -4 }, { 8, 9, 10 }, deflection);
    EXPECT_EQ(describeMesh(model).genus, 0);
  }
  const Model torus = parse(stepOf, stepBytes(torusPart()));
  expectSolid(torus, 2.0 * kPi * kPi * 20.0 * 25.0, 0.07);
  EXPECT_EQ(describeMesh(torus).genus, 1);
}

TEST(CadReader, KeepsADrilledHoleOpen)
{
  const double volume = volumeOf(drilledCylinderPart());
  for (const Model& model : { parse(stepOf, stepBytes(drilledCylinderPart())),
         parse(igesOf, igesBytes(drilledCylinderPart(), true)),
         parse(igesOf, igesBytes(drilledCylinderPart(), false)) })
  {
    expectSolid(model, volume, 0.042);
    EXPECT_EQ(describeMesh(model).genus, 1);
  }
}

TEST(CadReader, TurnsTheWallOfACavityInwards)
{
  const double volume = 4.0 / 3.0 * kPi * (343.0 - 125.0);
  const Model model = parse(stepOf, stepBytes(hollowBallPart()));
  expectSolid(model, volume, 0.025);
  EXPECT_EQ(describeMesh(model).components.size(), 2U);
}

TEST(CadReader, TurnsMirroredPartsOutwards)
{
  for (const Model& model : { parse(stepOf, stepBytes(mirroredPairPart())),
         parse(igesOf, igesBytes(mirroredPairPart(), true)) })
  {
    expectSolid(model, 12000.0, 1e-9);
    expectBox(model, { -50, 0, 0 }, { 30, 20, 10 }, 1e-9);
  }
}

TEST(CadReader, StaysWithinTheDeflection)
{
  for (const TopoDS_Shape& part : { drilledCylinderPart(), spherePart(), torusPart() })
  {
    std::size_t coarser = 0;
    for (const double deflection : { 1.0, 0.1, 0.01 })
    {
      const Model model = fineStep(part, deflection);
      expectSolid(model, volumeOf(part), deflection);
      EXPECT_LE(distanceFrom(part, middlesOf(model, 400)), deflection);
      EXPECT_LE(distanceFrom(part,
                  model.points.size() < 400
                    ? model.points
                    : std::vector<Vec3>(model.points.begin(), model.points.begin() + 400)),
        1e-6);
      EXPECT_GE(model.points.size(), coarser);
      coarser = model.points.size();
    }
  }
}

TEST(CadReader, GivesMillimetresWhateverTheUnit)
{
  for (const char* unit : { "MM", "INCH", "M" })
  {
    const Model model = parse(igesOf, igesBytes(boxPart(), true, unit));
    expectBox(model, { 0, 0, 0 }, { 30, 20, 10 }, 1e-6);
    EXPECT_EQ(model.millimetresPerUnit, 1.0);
  }
  const std::string step = stepBytes(boxPart());
  const Model model =
    parse(stepOf, replaced(step, "SI_UNIT(.MILLI.,.METRE.)", "SI_UNIT($,.METRE.)"));
  expectBox(model, { 0, 0, 0 }, { 30000, 20000, 10000 }, 1e-6);
  EXPECT_EQ(model.millimetresPerUnit, 1.0);
}

TEST(CadReader, GivesTheSameMeshAgain)
{
  const std::string bytes = stepBytes(drilledCylinderPart());
  const Model first = parse(stepOf, bytes);
  const Model second = parse(stepOf, bytes, 4);
  EXPECT_EQ(first.points, second.points);
  EXPECT_EQ(first.triangles, second.triangles);
}

TEST(CadReader, RecognisesItsFormats)
{
  const std::string step = stepBytes(boxPart());
  const std::string iges = igesBytes(boxPart(), true);
  EXPECT_TRUE(looksLikeStep(step));
  EXPECT_TRUE(looksLikeStep("\r\n ISO-10303-21;\nHEADER;"));
  EXPECT_TRUE(looksLikeIges(iges));
  EXPECT_FALSE(looksLikeStep(iges));
  EXPECT_FALSE(looksLikeIges(step));
  for (const std::string text : { "", "ISO-10303-2", "solid a\n", "1 2 3\n", "S      1" })
  {
    EXPECT_FALSE(looksLikeStep(text)) << text;
    EXPECT_FALSE(looksLikeIges(text)) << text;
  }
  EXPECT_FALSE(looksLikeIges(std::string(72, 'x') + "S      2\n"));
  EXPECT_FALSE(looksLikeIges(std::string(72, 'x') + "S"));
}

TEST(CadReader, SaysWhatIsWrong)
{
  const std::string step = stepBytes(boxPart());
  const std::string iges = igesBytes(boxPart(), true);
  EXPECT_EQ(
    parseError(stepOf, "solid a\n"), "file: not a STEP file: it does not start with ISO-10303-21;");
  EXPECT_EQ(parseError(stepOf, step.substr(0, step.size() / 2)),
    "file: the file ends early: END-ISO-10303-21; is missing; copy or export it again");
  EXPECT_EQ(parseError(stepOf, replaced(step, "#12 = ", "#12 = = (")),
    "file: OpenCASCADE cannot read the content; export it again from the CAD program");
  EXPECT_EQ(parseError(stepOf,
              "ISO-10303-21;\nHEADER;\nENDSEC;\nDATA;\n#1=CARTESIAN_POINT('',(0.,0.,0.));\n"
              "ENDSEC;\nEND-ISO-10303-21;\n"),
    "file: no surfaces found; export the model as surfaces or solids");
  EXPECT_EQ(parseError(igesOf, "solid a\n"),
    "file: not an IGES file: columns 73 to 80 of the first line are not S and the number 1");
  EXPECT_EQ(parseError(igesOf, std::string(72, ' ') + "C      1\n"),
    "file: compressed and binary IGES files cannot be read; export the fixed ASCII form");
  EXPECT_EQ(parseError(igesOf, iges.substr(0, iges.size() / 2)),
    "file: the file ends early: its last line is not the one of section T; copy or export it "
    "again");
  EXPECT_EQ(
    parseError(igesOf, std::string(72, ' ') + "S      1\n" + std::string(72, ' ') + "T      1\n"),
    "file: OpenCASCADE cannot read the content; export it again from the CAD program");
}

TEST(CadReader, RefusesOptionsOutOfRange)
{
  Execution execution;
  const std::string step = stepBytes(boxPart());
  for (const CadOptions& options : { CadOptions{ .deflection = -1.0 }, CadOptions{ .angle = 0.0 },
         CadOptions{ .deflection = std::nan("") }, CadOptions{ .angle = 4.0 } })
  {
    EXPECT_THROW(parseStep(step, "file", options, execution), Error);
  }
}

TEST(CadReader, PrintsNothing)
{
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  const std::string step = stepBytes(boxPart());
  parse(stepOf, step);
  parseError(stepOf, replaced(step, "#12 = ", "#12 = = ("));
  parse(igesOf, igesBytes(boxPart(), true));
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(CadReader, ReportsProgressAndStopsAtACancel)
{
  const std::string step = stepBytes(torusPart());
  std::vector<double> fractions;
  CancelToken token;
  Execution patient(1, token, [&](std::string_view, double f) { fractions.push_back(f); });
  patient.plan({ { "read", 1.0 } });
  parseStep(step, "file", {}, patient);
  EXPECT_GE(fractions.size(), 3U);
  EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));

  using Clock = std::chrono::steady_clock;
  Clock::time_point cancelled;
  const auto cancelOnce = [&](std::string_view, double fraction)
  {
    if (fraction > 0.0 && !token.cancelled())
    {
      token.cancel();
      cancelled = Clock::now();
    }
  };
  Execution hurried(1, token, cancelOnce);
  hurried.plan({ { "read", 1.0 } });
  // a billion triangles
  EXPECT_THROW(parseStep(step, "file", { .deflection = 1e-7 }, hurried), Cancelled);
  EXPECT_LT(Clock::now() - cancelled, std::chrono::milliseconds(500));
}

TEST(CadReader, EndsInErrorOrModelWhenCutOrChanged)
{
  const auto expectSafe = [&](auto parser, const std::string& bytes)
  {
    for (std::size_t size = 0; size + 100 < bytes.size(); size += 64)
    {
      EXPECT_NE(parseError(parser, bytes.substr(0, size)), "") << size;
    }
    for (std::size_t at = 0; at < bytes.size(); at += 97)
    {
      std::string changed = bytes;
      changed[at] = static_cast<char>(changed[at] ^ (at % 2 == 0 ? 0x01 : 0x15));
      expectErrorOrModel(parser, changed, "changed at " + std::to_string(at));
    }
    // the middle is missing, the end is there
    for (std::size_t from = 200; from + 800 < bytes.size(); from += 640)
    {
      expectErrorOrModel(parser, bytes.substr(0, from) + bytes.substr(from + 160),
        "cut out at " + std::to_string(from));
    }
  };
  expectSafe(stepOf, stepBytes(boxPart()));
  expectSafe(igesOf, igesBytes(boxPart(), true));
}

// ---- real parts

namespace
{

struct Part
{
  const char* file;
  std::size_t components;
  bool isClosed;
  double diagonal;
  double resolution = 0.0; ///< of edges that have been sewn

  friend void PrintTo(const Part& part, std::ostream* stream) { *stream << part.file; }
};

const std::string kFolder = SCAN_SHARED_DIR "/data/06_cad/";

class RealCadPart : public testing::TestWithParam<Part>
{
};

std::string nameOf(const testing::TestParamInfo<Part>& info)
{
  std::string name = info.param.file;
  std::replace_if(
    name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return name;
}

} // namespace

TEST_P(RealCadPart, IsTheSurfaceOfTheFile)
{
  const Part& part = GetParam();
  const std::string path = kFolder + part.file;
  if (!std::filesystem::exists(path))
  {
    GTEST_SKIP() << path << " is missing";
  }
  const MappedFile file(path);
  Execution execution;
  const Model model = looksLikeStep(file.bytes())
    ? parseStep(file.bytes(), file.name(), {}, execution)
    : parseIges(file.bytes(), file.name(), {}, execution);
  const MeshReport report = describeMesh(model);
  EXPECT_EQ(report.isClosed, part.isClosed);
  EXPECT_TRUE(report.isOriented);
  EXPECT_EQ(report.nonManifoldEdges, 0U);
  EXPECT_EQ(report.components.size(), part.components);
  EXPECT_NEAR(report.boxDiagonal, part.diagonal, 0.002 * part.diagonal);
  const TopoDS_Shape shape = shapeOf(path);
  const double deflection = 0.001 * part.diagonal;
  if (part.isClosed)
  {
    EXPECT_NEAR(report.volume.value_or(0.0), volumeOf(shape), deflection * report.area);
  }
  EXPECT_LE(distanceFrom(shape, middlesOf(model, 200)), deflection + part.resolution);
}

INSTANTIATE_TEST_SUITE_P(Cad, RealCadPart,
  testing::Values(Part{ "freecad/SOT404.igs", 5, false, 19.199 },
    Part{ "freecad/SOT404.stp", 5, false, 19.199 },
    Part{ "occt/bearing.iges", 1, false, 0.1614, 1e-4 },
    Part{ "occt/linkrods.step", 1, true, 5.607 }, Part{ "occt/screw.step", 1, true, 50.81 },
    Part{ "trimesh/base_interface_AP203.STEP", 1, true, 875.9 },
    Part{ "trimesh/base_interface_AP214.STEP", 1, true, 875.9 },
    Part{ "trimesh/featuretype.STEP", 1, true, 146.22 }),
  nameOf);
