// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/writers/other_programs.h"

#include "filters/base/error.h"
#include "readers/stl.h"
#include "tests/readers/parsing.h"
#include "tests/readers/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <sstream>

namespace scan::test
{
namespace
{

#ifdef SCAN_COIN_READER
constexpr const char* kCoinReader = SCAN_COIN_READER;
#else
constexpr const char* kCoinReader = "";
#endif

/// The numbers of the list behind a field's name, as SGI's Inventor prints it.
std::vector<double> fieldOf(const std::string& text, const std::string& field)
{
  const std::size_t start = text.find(field + "\t[");
  EXPECT_NE(start, std::string::npos) << field;
  std::string list = text.substr(start + field.size() + 2);
  list.resize(list.find(']'));
  std::replace(list.begin(), list.end(), ',', ' ');
  std::istringstream numbers(list);
  return { std::istream_iterator<double>(numbers), {} };
}

/// The number behind a label in what a program prints; 0 when the label is not there.
double numberBehind(const std::string& text, const std::string& label)
{
  const std::size_t at = text.find(label);
  return at == std::string::npos ? 0.0 : std::strtod(text.c_str() + at + label.size(), nullptr);
}

} // namespace

std::string outputOf(const std::string& command)
{
  std::FILE* const pipe = ::popen(("( " + command + " ) 2>&1").c_str(), "r");
  std::string output;
  std::array<char, 4096> block = {};
  while (const std::size_t n = std::fread(block.data(), 1, block.size(), pipe))
  {
    output.append(block.data(), n);
  }
  const int status = ::pclose(pipe);
  return status == 0 ? output : output + "\nstatus " + std::to_string(status);
}

bool isInstalled(const std::string& command)
{
  return std::system((command + " > /dev/null 2>&1").c_str()) == 0;
}

bool hasAssimp()
{
  return isInstalled("command -v assimp");
}

TriMesh readWithAssimp(const std::string& path)
{
  const std::string stl = path + ".assimp.stl";
  const std::string output = outputOf("assimp export " + path + " " + stl + " -fstlb");
  if (output.find("wrote output file") == std::string::npos)
  {
    throw Error(ErrorCode::io, output);
  }
  return parse(parseStl, contentOf(stl));
}

void turnBackFromAssimp(TriMesh& mesh)
{
  for (Vec3& p : mesh.points)
  {
    p = { p.x, -p.z, p.y };
  }
}

bool hasLib3ds()
{
  return isInstalled("command -v 3dsdump");
}

Lib3dsResult readWithLib3ds(const std::string& path)
{
  std::istringstream text(outputOf("3dsdump -t " + path));
  Lib3dsResult result;
  Index first = 0;
  std::string line;
  while (std::getline(text, line))
  {
    Vec3 p;
    char name[64] = {};
    std::size_t points = 0;
    std::size_t faces = 0;
    Triangle t = {};
    unsigned flags = 0;
    if (std::sscanf(line.c_str(), " %63s vertices=%zu faces=%zu", name, &points, &faces) == 3)
    {
      result.parts.push_back({ name, points, faces });
      first = static_cast<Index>(result.mesh.points.size());
    }
    else if (std::sscanf(
               line.c_str(), " %u %u %u smoothing:%*d flags:%u", &t[0], &t[1], &t[2], &flags) == 4)
    {
      EXPECT_EQ(flags, 7U);
      result.mesh.triangles.push_back({ first + t[0], first + t[1], first + t[2] });
    }
    else if (line.starts_with("    ") &&
      std::sscanf(line.c_str(), " %lf %lf %lf", &p.x, &p.y, &p.z) == 3)
    {
      result.mesh.points.push_back(p);
    }
  }
  return result;
}

bool hasEzdxf()
{
  return isInstalled("/usr/bin/python3 -c 'import ezdxf'");
}

EzdxfResult readWithEzdxf(const std::string& path)
{
  const std::string output =
    outputOf("/usr/bin/python3 " SCAN_DATA_DIR "/../tests/writers/read_dxf.py " + path);
  std::istringstream text(output);
  EzdxfResult result;
  text >> result.complaints >> result.meshes;
  const auto readPoints = [&](std::size_t pointsEach)
  {
    std::size_t count = 0;
    text >> count;
    for (std::size_t i = 0; i < count * pointsEach && text; ++i)
    {
      Vec3 p;
      text >> p.x >> p.y >> p.z;
      result.mesh.points.push_back(p);
    }
    return count;
  };
  const std::size_t triangles = readPoints(3);
  for (Index i = 0; i < triangles; ++i)
  {
    result.mesh.triangles.push_back({ 3 * i, 3 * i + 1, 3 * i + 2 });
  }
  readPoints(1);
  std::size_t curves = 0;
  text >> curves;
  for (std::size_t i = 0; i < curves && text; ++i)
  {
    int isClosed = 0;
    std::size_t size = 0;
    text >> isClosed >> size;
    std::vector<Vec3>& curve = result.curves.emplace_back(size);
    for (Vec3& p : curve)
    {
      text >> p.x >> p.y >> p.z;
    }
    if (isClosed != 0)
    {
      curve.push_back(Vec3{ curve.front() });
    }
  }
  EXPECT_FALSE(text.fail()) << output.substr(0, 2000);
  return result;
}

bool hasCoin()
{
  return *kCoinReader != '\0';
}

Model readWithCoin(const std::string& path)
{
  std::istringstream text(outputOf(std::string(kCoinReader) + " " + path));
  Model model;
  const auto readLines = [&](const std::string& kind, std::size_t linesEach)
  {
    std::string word;
    std::size_t count = 0;
    text >> word >> count;
    EXPECT_EQ(word, kind) << text.str().substr(0, 2000);
    for (std::size_t i = 0; i < count * linesEach; ++i)
    {
      Vec3 p;
      Vec3 c;
      text >> p.x >> p.y >> p.z >> c.x >> c.y >> c.z;
      model.points.push_back(
        { static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z) });
      c = c * 255.0 + Vec3{ 0.5, 0.5, 0.5 };
      model.colors.push_back({ static_cast<std::uint8_t>(c.x), static_cast<std::uint8_t>(c.y),
        static_cast<std::uint8_t>(c.z) });
    }
    return count;
  };
  const std::size_t triangles = readLines("triangles", 3);
  for (Index i = 0; i < triangles; ++i)
  {
    model.triangles.push_back({ 3 * i, 3 * i + 1, 3 * i + 2 });
  }
  readLines("points", 1);
  const auto first = static_cast<Index>(model.points.size());
  const std::size_t lines = readLines("lines", 2);
  for (Index i = 0; i < lines; ++i)
  {
    model.curves.corners.insert(model.curves.corners.end(), { first + 2 * i, first + 2 * i + 1 });
    model.curves.endLine();
  }
  EXPECT_FALSE(text.fail());
  return model;
}

bool hasSgiInventor()
{
  return isInstalled("command -v ivcat");
}

Model readWithSgiInventor(const std::string& path)
{
  const std::string text = outputOf("ivcat " + path);
  EXPECT_EQ(text.find("read error"), std::string::npos) << text.substr(0, 500);
  Model model;
  const std::vector<double> points = fieldOf(text, "point");
  for (std::size_t i = 0; i + 2 < points.size(); i += 3)
  {
    model.points.push_back({ points[i], points[i + 1], points[i + 2] });
  }
  const std::vector<double> indices = fieldOf(text, "coordIndex");
  for (std::size_t i = 0; i + 3 < indices.size(); i += 4)
  {
    EXPECT_EQ(indices[i + 3], -1.0);
    model.triangles.push_back({ static_cast<Index>(indices[i]), static_cast<Index>(indices[i + 1]),
      static_cast<Index>(indices[i + 2]) });
  }
  return model;
}

bool hasAdmesh()
{
  return isInstalled("command -v admesh");
}

AdmeshResult readWithAdmesh(const std::string& path)
{
  // what is joined exactly, and what it would turn; nothing else is repaired
  const std::string text = outputOf("admesh --exact --normal-directions --normal-values " + path);
  const auto count = [&](const std::string& label)
  { return static_cast<std::size_t>(numberBehind(text, label)); };
  return { .facets = count("Number of facets                 :"),
    .degenerate = count("Degenerate facets     :"),
    .open = count("Total disconnected facets        :"),
    .backwards = count("Backwards edges       :") + count("Facets reversed       :"),
    .wrongNormals = count("Normals fixed         :"),
    .parts = count("Number of parts       :"),
    .volume = numberBehind(text, "Volume   :"),
    .low = { numberBehind(text, "Min X ="), numberBehind(text, "Min Y ="),
      numberBehind(text, "Min Z =") },
    .high = { numberBehind(text, "Max X ="), numberBehind(text, "Max Y ="),
      numberBehind(text, "Max Z =") } };
}

} // namespace scan::test
