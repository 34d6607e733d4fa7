// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Every cell of the table of formats against what comes in from files and what others find in ours.
#include "readers/cyberware_header.h"
#include "tests/pipeline/format_files.h"
#include "tests/readers/cyberware_files.h"
#include "tests/writers/iges_structure.h"
#include "tests/writers/models.h"
#include "tests/writers/other_programs.h"

#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <optional>
#include <ostream>
#include <set>

using namespace scan;
using namespace scan::test;

namespace scan
{

// GoogleTest finds it by its name
static void PrintTo(const Format& format, std::ostream* stream)
{
  *stream << format.name;
}

} // namespace scan

namespace
{

constexpr double kInch = 25.4;

// ---- models

/// An open surface with curves on it, and colours, normals and a unit.
Model fullModel()
{
  Model model = colored(withCurves(grid(2, 3, false)));
  for (std::size_t i = 0; i < model.points.size(); ++i)
  {
    model.normals.push_back(i % 2 == 0 ? Vec3{ 0, 0.6, 0.8 } : Vec3{ -1, 0, 0 });
  }
  model.millimetresPerUnit = kInch;
  return model;
}

Model onlyPoints(Model model)
{
  model.triangles.clear();
  model.curves = {};
  return model;
}

Model onlyCurves(Model model)
{
  model.triangles.clear();
  return model;
}

// ---- what is in files

/// The columns of the table, as files show them.
struct Seen
{
  bool points = false;
  bool triangles = false;
  bool curves = false;
  bool colors = false;
  bool normals = false;
  std::set<double> units = {}; // without 0

  void add(const Model& model)
  {
    this->points = this->points || (model.isScan() && !model.points.empty());
    this->triangles = this->triangles || !model.triangles.empty();
    this->curves = this->curves || !model.curves.empty();
    this->colors = this->colors || !model.colors.empty();
    this->normals = this->normals || !model.normals.empty();
    if (model.millimetresPerUnit > 0.0)
    {
      this->units.insert(model.millimetresPerUnit);
    }
  }

  std::string unit() const
  {
    return this->units.empty()                  ? ""
      : this->units == std::set<double>{ 1.0 }  ? "millimetre"
      : this->units == std::set<double>{ 1000 } ? "metre"
                                                : "in the file";
  }
};

void expectCells(const Seen& seen, const Abilities& promised)
{
  EXPECT_EQ(seen.points, promised.points);
  EXPECT_EQ(seen.triangles, promised.triangles);
  EXPECT_EQ(seen.curves, promised.curves);
  EXPECT_EQ(seen.colors, promised.colors);
  EXPECT_EQ(seen.normals, promised.normals);
  EXPECT_EQ(seen.unit(), promised.unit);
}

// ---- files of others, by the name of their format

std::string corpusFile(const std::string& name)
{
  return contentOf(SCAN_CORPUS_DIR "/" + name);
}

/// A file, and with which options it is read.
struct Sample
{
  std::string content;
  ReadAs as = ReadAs::automatic;
};

/// A mesh without faces.
std::string pointsOf3ds()
{
  const auto number = [](std::size_t value, int width)
  {
    std::string bytes;
    appendInteger(bytes, static_cast<std::int64_t>(value), width, false);
    return bytes;
  };
  const auto chunk = [&](std::size_t id, const std::string& content)
  { return number(id, 2) + number(content.size() + 6, 4) + content; };
  const std::string vertices = number(2, 2) + std::string(24, '\0');
  const std::string object = std::string("a\0", 2) + chunk(0x4100, chunk(0x4110, vertices));
  return chunk(0x4d4d, chunk(0x3d3d, chunk(0x4000, object)));
}

const std::multimap<std::string, Sample>& samples()
{
  static const std::string vtk = "# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\n";
  static const std::string pcd = "VERSION 0.7\nFIELDS x y z rgb normal_x normal_y normal_z\n"
                                 "SIZE 4 4 4 4 4 4 4\nTYPE F F F U F F F\nCOUNT 1 1 1 1 1 1 1\n"
                                 "WIDTH 1\nHEIGHT 1\nPOINTS 1\nDATA ascii\n1 2 3 65280 0 0 1\n";
  static const std::string ply =
    "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
    "property float z\nproperty float nx\nproperty float ny\nproperty float nz\nproperty uchar "
    "red\nproperty uchar green\nproperty uchar blue\nend_header\n1 2 3 0 0 1 7 8 9\n";
  static CyberwareMap map;
  static const std::multimap<std::string, Sample> kSamples = {
    { "PLY", { ply } },
    { "PLY", { corpusFile("ply/little.ply") } },
    { "STL", { corpusFile("stl/ascii.stl") } },
    { "STL", { corpusFile("stl/binary.stl") } },
    { "OBJ", { "v 1 2 3 7 8 9\nv 1 2 4 7 8 9\nvn 0 0 1\nvn 0 1 0\n" } },
    { "OBJ", { "v 1 2 3\nv 1 2 4\nv 2 2 4\nf 1 2 3\nl 1 2\n" } },
    { "OFF", { "CNOFF\n1 0 0\n1 2 3 0 1 0 10 20 30 255\n" } },
    { "OFF", { corpusFile("off/plain.off") } },
    { "3D Studio", { corpusFile("autodesk_3ds/two.3ds") } },
    { "3D Studio", { pointsOf3ds() } },
    { "IGES", { corpusFile("iges/faces") } },
    { "IGES", { corpusFile("iges/solid") } },
    { "glTF", { corpusFile("gltf/scene.glb") } },
    { "glTF", { corpusFile("gltf/embedded.gltf") } },
    { "3MF", { corpusFile("threemf/stored") } },
    { "3MF", { corpusFile("threemf/deflated") } },
    { "STEP", { corpusFile("step/ball") } },
    { "VTK XML PolyData",
      { "<VTKFile type=\"PolyData\"><PolyData><Piece NumberOfPoints=\"1\"><Points><DataArray "
        "type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">1 2 3</DataArray></Points>"
        "</Piece></PolyData></VTKFile>\n" } },
    { "legacy VTK", { corpusFile("legacy_vtk/text") } },
    { "legacy VTK", { corpusFile("legacy_vtk/binary") } },
    { "legacy VTK", { vtk + "POINTS 1 float\n1 2 3\n" } },
    { "LAS", { corpusFile("las/format0.las") } },
    { "LAS", { corpusFile("las/format2.las") } },
    { "PCD", { pcd } },
    { "PCD", { corpusFile("pcd/binary.pcd") } },
    { "Cyberware range map", { cyberwareText(map) } },
    { "Cyberware range map", { cyberwareText(map), ReadAs::mesh } },
    { "PTX", { corpusFile("ptx/colors.ptx") } },
    { "PTX", { corpusFile("ptx/scan.ptx") } },
    { "PTS", { corpusFile("pts/colors.pts") } },
    { "PTS", { "2\n1 2 3\n4 5 6\n" } },
    { "Digibotics contours", { corpusFile("digibotics/slices.dig") } },
    { "Digibotics contours", { "UNITS MM\nslice 1\n1 2 3\n4 5 6\nslice 2\n1 2 4\n4 5 7\n" } },
    { "points as text", { "x y z r g b nx ny nz\n1 2 3 7 8 9 0 0 1\n" } },
    { "points as text", { "1 2 3\n4 5 6\n" } },
  };
  return kSamples;
}

/// The colour companion of a range map.
void addCompanions(const Format& format, const std::string& path)
{
  if (format.name == "Cyberware range map")
  {
    setContent(path + ".color", corpusFile("sgi_image/raw3.sgi"));
  }
}

// ---- files of ours

bool isThere(const Format& format)
{
  return format.makeReader != nullptr || (format.name == "DXF" ? hasEzdxf() : hasCoin());
}

Model curvesOf(const std::vector<std::vector<Vec3>>& curves)
{
  Model model;
  for (const std::vector<Vec3>& curve : curves)
  {
    for (const Vec3& point : curve)
    {
      model.curves.corners.push_back(static_cast<Index>(model.points.size()));
      model.points.push_back(point);
    }
    model.curves.endLine();
  }
  return model;
}

Model readDxf(const std::string& path)
{
  const EzdxfResult result = readWithEzdxf(path);
  Model model = curvesOf(result.curves);
  const auto before = static_cast<Index>(model.points.size());
  model.points.insert(model.points.end(), result.mesh.points.begin(), result.mesh.points.end());
  for (const auto& [a, b, c] : result.mesh.triangles)
  {
    model.triangles.push_back({ before + a, before + b, before + c });
  }
  return model;
}

/// What our reader, of surfaces only, leaves out: points and polylines.
Model readIges(const std::string& path)
{
  const IgesStructure structure(contentOf(path));
  EXPECT_EQ(structure.fault(), "");
  if (structure.count(510, 1) + structure.count(108, 1) + structure.count(514, 1) > 0)
  {
    Model model = readFile(path);
    model.curves = structure.count(106, 12) > 0 ? Polylines{ { 0, 1 }, { 2 } } : Polylines();
    return model;
  }
  Model model;
  for (const IgesStructure::Entity& entity : structure.entities())
  {
    if (entity.type == 116)
    {
      model.points.push_back({ std::stod(entity.parameters[1]), std::stod(entity.parameters[2]),
        std::stod(entity.parameters[3]) });
    }
    if (entity.type == 106)
    {
      model.curves = { { 0, 1 }, { 2 } };
      model.points.resize(2);
    }
  }
  return model;
}

/// With a program that is not ours where we do not read the format.
Model readBack(const Format& format, const std::string& path)
{
  return format.name == "DXF"      ? readDxf(path)
    : format.name == "IGES"        ? readIges(path)
    : format.makeReader == nullptr ? readWithCoin(path)
                                   : readFile(path);
}

/// The file of a model, or nothing when the format cannot hold any of it.
std::optional<Model> thereAndBack(
  const Format& format, const Model& model, const ParameterValues& given = {})
{
  const TemporaryFolder folder;
  const std::string path = folder.file("file." + format.extensions.front());
  try
  {
    writeFile(path, model, given);
  }
  catch (const std::runtime_error&)
  {
    EXPECT_EQ(folder.fileCount(), 0U);
    return std::nullopt;
  }
  return readBack(format, path);
}

std::string labelOf(const testing::TestParamInfo<Format>& info)
{
  std::string name = info.param.name;
  std::erase_if(name, [](char c) { return c == ' '; });
  return name;
}

std::vector<Format> allThat(bool (*isWanted)(const Format&))
{
  std::vector<Format> all;
  std::ranges::copy_if(formats(), std::back_inserter(all), isWanted);
  return all;
}

class ReadFormat : public testing::TestWithParam<Format>
{
};

class WrittenFormat : public testing::TestWithParam<Format>
{
protected:
  void SetUp() override
  {
    if (!isThere(GetParam()))
    {
      GTEST_SKIP() << "the program that reads " << GetParam().name << " is missing";
    }
  }
};

} // namespace

// ---- reading

TEST_P(ReadFormat, BringsInWhatTheTableSays)
{
  const Format& format = GetParam();
  const TemporaryFolder folder;
  Seen seen;
  const auto [begin, end] = samples().equal_range(format.name);
  int number = 0;
  for (auto sample = begin; sample != end; ++sample)
  {
    const std::string path =
      folder.file(std::to_string(++number) + "." + format.extensions.front());
    setContent(path, sample->second.content);
    addCompanions(format, path);
    seen.add(readFile(path, { .as = sample->second.as }));
  }
  EXPECT_GT(number, 0);
  if (format.makeWriter != nullptr && format.name != "IGES")
  {
    for (const Model& model : { fullModel(), onlyPoints(fullModel()), onlyCurves(fullModel()) })
    {
      const std::optional<Model> back = thereAndBack(format, model);
      seen.add(back ? *back : Model());
    }
  }
  expectCells(seen, format.reads);
}

TEST_P(ReadFormat, IsFoundByContentUnderEachOfItsNames)
{
  const Format& format = GetParam();
  const TemporaryFolder folder;
  std::vector<std::string> names = format.extensions;
  names.push_back("dat");
  const auto [begin, end] = samples().equal_range(format.name);
  for (auto sample = begin; sample != end; ++sample)
  {
    for (const std::string& name : names)
    {
      setContent(folder.file("file." + name), sample->second.content);
      EXPECT_EQ(formatToRead(folder.file("file." + name), {}).name, format.name) << name;
    }
  }
}

// ---- writing

TEST_P(WrittenFormat, HoldsWhatTheTableSays)
{
  const Format& format = GetParam();
  Seen seen;
  for (const double unit : { 1.0, kInch })
  {
    for (Model model : { fullModel(), onlyPoints(fullModel()), onlyCurves(fullModel()) })
    {
      model.millimetresPerUnit = unit;
      const std::optional<Model> back = thereAndBack(format, model);
      seen.add(back ? *back : Model());
    }
  }
  Abilities promised = format.writes;
  if (format.name == "IGES") // read in millimetres whatever it says
  {
    promised.unit = "millimetre";
  }
  expectCells(seen, promised);
}

TEST_P(WrittenFormat, KeepsPlacesColorsAndNormals)
{
  const Format& format = GetParam();
  Model model = fullModel();
  model = format.writes.triangles ? model : onlyPoints(model);
  const std::optional<Model> back = thereAndBack(format, model);
  ASSERT_TRUE(back);
  const double scale = back->millimetresPerUnit > 0.0 ? kInch / back->millimetresPerUnit : 1.0;
  expectSame(*back, moved(model, {}, scale));
  if (format.writes.colors)
  {
    EXPECT_EQ(std::set<Color>(back->colors.begin(), back->colors.end()),
      std::set<Color>(model.colors.begin(), model.colors.end()));
  }
  if (format.writes.normals)
  {
    ASSERT_EQ(back->normals.size(), model.normals.size());
    for (std::size_t i = 0; i < model.normals.size(); ++i)
    {
      const Vec3 difference = back->normals[i] - model.normals[i];
      EXPECT_LE(dot(difference, difference), 1e-12) << i;
    }
  }
}

TEST_P(WrittenFormat, KeepsLargeCoordinates)
{
  const Format& format = GetParam();
  if (format.name == "3D Studio" || format.makeReader == nullptr)
  {
    GTEST_SKIP() << "float32 by its definition, or read with other programs only";
  }
  const Vec3 far = { 5e6 + 0.123456789, -4e6 - 1.0 / 3.0, 3e6 }; // metres
  Model model = moved(grid(5, 4, true), far);
  model = format.writes.triangles ? model : onlyPoints(model);
  model.millimetresPerUnit = 1000.0;
  const bool isStl = format.name == "STL";
  const std::optional<Model> back = thereAndBack(format, model,
    isStl ? ParameterValues{ { "encoding", std::string("ascii") } } : ParameterValues());
  ASSERT_TRUE(back);
  const double scale = back->millimetresPerUnit > 0.0 ? back->millimetresPerUnit / 1000.0 : 1.0;
  const Summary found = summaryOf(moved(*back, {}, scale));
  const Summary expected = summaryOf(model);
  EXPECT_EQ(found.points, expected.points);
  const Vec3 low = found.lowest - expected.lowest;
  const Vec3 high = found.highest - expected.highest;
  EXPECT_LE(std::sqrt(std::max(dot(low, low), dot(high, high))), 1e-9 * 5e6);
}

TEST_P(WrittenFormat, SaysWhatItLeavesOut)
{
  const Format& format = GetParam();
  const Abilities& can = format.writes;
  vtkNew<vtkPolyData> data;
  bridge::setModel(*data, fullModel());
  std::string lost;
  for (const auto& [isHeld, what] : { std::pair{ can.triangles, "triangles" },
         { can.curves, "curves" }, { can.colors, "colours" }, { can.normals, "normals" } })
  {
    lost += isHeld ? "" : lost.empty() ? what : std::string(", ") + what;
  }
  EXPECT_EQ(lossesOf(format, *data),
    lost.empty() ? "" : "the format holds no " + lost + "; they are left out");
}

TEST_P(WrittenFormat, IsFoundByEachOfItsNames)
{
  const Format& format = GetParam();
  for (const std::string& name :
    format.writeExtensions.empty() ? format.extensions : format.writeExtensions)
  {
    EXPECT_EQ(formatToWrite("file." + name).name, format.name) << name;
  }
}

INSTANTIATE_TEST_SUITE_P(Table, ReadFormat,
  testing::ValuesIn(allThat([](const Format& f) { return f.makeReader != nullptr; })), labelOf);
INSTANTIATE_TEST_SUITE_P(Table, WrittenFormat,
  testing::ValuesIn(
    allThat([](const Format& f) { return f.makeWriter != nullptr && !f.isPicture; })),
  labelOf);

// ---- limits

namespace
{

const Format& formatNamed(const std::string& name)
{
  return *std::ranges::find(formats(), name, &Format::name);
}

/// Whether a coordinate of many digits comes back as float32 holds it.
bool isSinglePrecision(const std::string& format, const ParameterValues& given = {})
{
  Model model = oneTriangle();
  model.points[1].x = 1.0 / 3.0;
  const std::optional<Model> back = thereAndBack(formatNamed(format), model, given);
  EXPECT_TRUE(back);
  const auto at = std::ranges::find_if(
    back->points, [](const Vec3& p) { return std::abs(p.x - 1.0 / 3.0) < 1e-6; });
  EXPECT_NE(at, back->points.end());
  return at->x == static_cast<double>(static_cast<float>(1.0 / 3.0));
}

std::string messageOf(const std::function<void()>& run)
{
  try
  {
    run();
  }
  catch (const std::runtime_error& error)
  {
    return error.what();
  }
  return "done";
}

void expectMessage(const std::string& part, const std::function<void()>& run)
{
  EXPECT_NE(messageOf(run).find(part), std::string::npos) << messageOf(run);
}

void limitOfStl()
{
  EXPECT_TRUE(isSinglePrecision("STL"));
  EXPECT_FALSE(isSinglePrecision("STL", { { "encoding", std::string("ascii") } }));
}

void limitsOf3ds()
{
  EXPECT_TRUE(isSinglePrecision("3D Studio"));
  if (hasLib3ds())
  {
    const TemporaryFolder folder;
    writeFile(folder.file("a.3ds"), grid(200, 200, true));
    const Lib3dsResult result = readWithLib3ds(folder.file("a.3ds"));
    EXPECT_EQ(result.parts.size(), 2U);
    for (const Lib3dsPart& part : result.parts)
    {
      EXPECT_LE(std::max(part.points, part.faces), 65535U);
    }
  }
}

void limitsOfDxf()
{
  if (hasEzdxf())
  {
    const TemporaryFolder folder;
    writeFile(folder.file("a.dxf"), grid(150, 150, true), { { "faces", std::string("polyface") } });
    const EzdxfResult result = readWithEzdxf(folder.file("a.dxf"));
    EXPECT_EQ(result.meshes, 2); // 45,000 triangles
    EXPECT_EQ(result.mesh.triangles.size(), 45000U);
  }
}

/// IGES counts lines with seven digits.
void limitsOfIges()
{
  const auto most = [](const char* entities)
  {
    const TemporaryFolder folder;
    Model model = moved(grid(20, 20, true), { 1.0 / 3.0, 1.0 / 7.0, 1.0 / 9.0 }); // all digits
    writeFile(folder.file("a.igs"), model, { { "entities", std::string(entities) } });
    const std::string text = contentOf(folder.file("a.igs"));
    const std::size_t lines = std::stoul(text.substr(text.rfind('P') + 1, 7));
    return 9999999.0 / static_cast<double>(lines) * static_cast<double>(model.triangles.size());
  };
  EXPECT_GE(most("faces"), 1.5e6);
  EXPECT_LE(most("faces"), 1.6e6);
  EXPECT_GE(most("solid"), 0.8e6);
  EXPECT_LE(most("solid"), 1.0e6);
}

void limitsOfGlb()
{
  const Vec3 far = { 1e7, -2e7, 3e7 };
  Model model = moved(grid(20, 20, true), far);
  model.millimetresPerUnit = 1000.0;
  const std::optional<Model> back = thereAndBack(formatNamed("glTF"), model);
  ASSERT_TRUE(back);
  for (std::size_t i = 0; i < model.points.size(); ++i)
  {
    const Vec3 difference = back->points[i] - model.points[i];
    ASSERT_LE(dot(difference, difference), 1e-10) << i; // of 80 m
  }
}

void limitOfLas()
{
  const TemporaryFolder folder;
  setContent(folder.file("a.las"), corpusFile("las/laz.las"));
  expectMessage("compressed", [&] { readFile(folder.file("a.las")); });
}

void limitOfCyberware()
{
  const TemporaryFolder folder;
  setContent(folder.file("a.cy"), cyberwareText(CyberwareMap()));
  EXPECT_TRUE(readFile(folder.file("a.cy")).triangles.empty());
  EXPECT_FALSE(readFile(folder.file("a.cy"), { .as = ReadAs::mesh }).triangles.empty());
}

void limitsOfDigibotics()
{
  const TemporaryFolder folder;
  setContent(folder.file("a.dig"), corpusFile("digibotics/binary.dig"));
  expectMessage("binary", [&] { readFile(folder.file("a.dig")); });
  setContent(folder.file("b.dig"), corpusFile("digibotics/slices.dig"));
  EXPECT_NE(readFile(folder.file("b.dig")).note.find("not verified"), std::string::npos);
}

} // namespace

TEST(FormatTable, LimitsAreWhatItSays)
{
  const std::map<std::string, std::pair<std::string, void (*)()>> checks = {
    { "STL", { "binary: 7 digits", limitOfStl } },
    { "3D Studio", { "7 digits; parts of 65,535 points or triangles", limitsOf3ds } },
    { "DXF", { "polyface: parts of 32,767 points or triangles", limitsOfDxf } },
    { "IGES", { "9,999,999 lines: 1.5 million triangles, 800,000 as a solid", limitsOfIges } },
    { "glTF", { "written as glb: 7 digits around the centre, 4 GB", limitsOfGlb } },
    { "LAS", { "not compressed", limitOfLas } },
    { "Cyberware range map", { "triangles with --as=mesh", limitOfCyberware } },
    { "Digibotics contours", { "text; not verified", limitsOfDigibotics } },
  };
  for (const Format& format : formats())
  {
    const std::string& limits =
      format.writes.limits.empty() ? format.reads.limits : format.writes.limits;
    const auto check = checks.find(format.name);
    SCOPED_TRACE(format.name);
    ASSERT_EQ(check != checks.end(), !limits.empty()) << "a limit without a check, or none";
    if (check != checks.end())
    {
      EXPECT_EQ(check->second.first, limits);
      check->second.second();
    }
  }
}

TEST(FormatTable, FormatsWithoutDigitsInTheirLimitsKeepThemAll)
{
  for (const Format& format : formats())
  {
    const bool isExact = format.writes.limits.find("digits") == std::string::npos;
    if (isExact && format.makeWriter != nullptr && format.writes.triangles && isThere(format) &&
      format.makeReader != nullptr)
    {
      EXPECT_FALSE(isSinglePrecision(format.name)) << format.name;
    }
  }
}
