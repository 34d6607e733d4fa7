// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Reading files from a warm page cache: ours, VTK's and assimp's in the same run, bytes of file per
// second.
#include "readers/mapped_file.h"
#include "readers/obj.h"
#include "readers/ply.h"
#include "readers/points_text.h"
#include "readers/stl.h"
#include "tests/readers/parsing.h"
#include "tests/readers/temporary_folder.h"
#include "writers/obj.h"
#include "writers/ply.h"
#include "writers/stl.h"

#include <vtkNew.h>
#include <vtkOBJReader.h>
#include <vtkPLYReader.h>
#include <vtkPolyData.h>
#include <vtkSTLReader.h>
#include <vtkSimplePointsReader.h>

#if SCAN_HAS_ASSIMP
#include <assimp/Importer.hpp>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#endif

#include <benchmark/benchmark.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <random>

namespace
{

constexpr std::size_t kLines = 5000000;
constexpr scan::Index kGrid = 708; // about a million triangles

/// The files, made once.
class Files
{
public:
  Files()
  {
    this->writePoints("model.xyz", "");
    this->writePoints("colored.xyz", "10 128 255");
    scan::Model mesh = grid();
    scan::Execution execution;
    this->writeMesh(mesh, "model");
    mesh.colors.assign(mesh.points.size(), { 10, 128, 255 });
    this->writeMesh(mesh, "colored");
    mesh.normals.assign(mesh.points.size(), { 0.0, 0.6, 0.8 });
    this->writeMesh(mesh, "shaded");
    for (const bool isText : { false, true })
    {
      scan::OutputFile stl(this->path(isText ? "ascii.stl" : "model.stl"));
      const auto encoding = isText ? scan::Encoding::ascii : scan::Encoding::binary;
      scan::writeStl(mesh, { encoding }, stl, execution);
      stl.commit();
    }
  }

  std::string path(const std::string& name) const { return this->Folder.file(name); }

private:
  void writeMesh(const scan::Model& mesh, const std::string& name) const
  {
    scan::Execution execution;
    scan::OutputFile ply(this->path(name + ".ply"));
    scan::writePly(mesh, {}, ply, execution);
    ply.commit();
    scan::OutputFile obj(this->path(name + ".obj"));
    scan::writeObj(mesh, obj, execution);
    obj.commit();
  }

  /// Lines of three numbers with six decimals, as scanners write them, and what follows them.
  void writePoints(const std::string& name, std::string_view further) const
  {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> coordinate(-100.0, 100.0);
    scan::OutputFile file(this->path(name));
    for (std::size_t i = 0; i < kLines; ++i)
    {
      char line[96];
      char* end = line;
      for (int k = 0; k < 3; ++k)
      {
        end =
          std::to_chars(end, line + sizeof(line), coordinate(random), std::chars_format::fixed, 6)
            .ptr;
        *end++ = ' ';
      }
      end = further.empty() ? end - 1 : std::copy(further.begin(), further.end(), end);
      *end++ = '\n';
      file.write({ line, static_cast<std::size_t>(end - line) });
    }
    file.commit();
  }

  /// A wavy square whose coordinates have six decimals.
  static scan::Model grid()
  {
    scan::Model mesh;
    for (scan::Index i = 0; i < kGrid; ++i)
    {
      for (scan::Index j = 0; j < kGrid; ++j)
      {
        const double z = std::sin(i * 0.05) * std::cos(j * 0.03);
        mesh.points.push_back({ i * 0.125, j * 0.125, std::round(z * 1e6) * 1e-6 });
      }
    }
    for (scan::Index i = 0; i + 1 < kGrid; ++i)
    {
      for (scan::Index j = 0; j + 1 < kGrid; ++j)
      {
        const scan::Index a = i * kGrid + j;
        mesh.triangles.push_back({ a, a + kGrid, a + 1 });
        mesh.triangles.push_back({ a + 1, a + kGrid, a + kGrid + 1 });
      }
    }
    return mesh;
  }

  scan::test::TemporaryFolder Folder;
};

void readOurs(benchmark::State& state, scan::test::Parser parser, const std::string& path)
{
  const auto threads = static_cast<unsigned>(state.range(0));
  for (auto _ : state)
  {
    const scan::MappedFile file(path);
    scan::Execution execution(threads);
    benchmark::DoNotOptimize(parser(file.bytes(), file.name(), execution));
  }
  state.SetBytesProcessed(
    static_cast<std::int64_t>(state.iterations() * std::filesystem::file_size(path)));
}

template <class Reader>
void readVtk(benchmark::State& state, const std::string& path)
{
  for (auto _ : state)
  {
    vtkNew<Reader> reader;
    reader->SetFileName(path.c_str());
    reader->Update();
    benchmark::DoNotOptimize(reader->GetOutput()->GetNumberOfPoints());
  }
  state.SetBytesProcessed(
    static_cast<std::int64_t>(state.iterations() * std::filesystem::file_size(path)));
}

#if SCAN_HAS_ASSIMP
/// With shared vertices, as the other readers give them.
void readAssimp(benchmark::State& state, const std::string& path)
{
  for (auto _ : state)
  {
    Assimp::Importer importer;
    benchmark::DoNotOptimize(
      importer.ReadFile(path, aiProcess_JoinIdenticalVertices | aiProcess_Triangulate));
  }
  state.SetBytesProcessed(
    static_cast<std::int64_t>(state.iterations() * std::filesystem::file_size(path)));
}
#endif

void addOurs(const Files& files, const std::string& name, scan::test::Parser parser)
{
  benchmark::RegisterBenchmark(
    (name + "/scanwrap/threads").c_str(), readOurs, parser, files.path(name))
    ->Arg(1)
    ->Arg(2)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
}

template <class Rival>
void compare(const Files& files, const std::string& name, scan::test::Parser parser)
{
  addOurs(files, name, parser);
  benchmark::RegisterBenchmark((name + "/vtk").c_str(), readVtk<Rival>, files.path(name))
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
#if SCAN_HAS_ASSIMP
  if (!name.ends_with(".xyz")) // which it does not read
  {
    benchmark::RegisterBenchmark((name + "/assimp").c_str(), readAssimp, files.path(name))
      ->Unit(benchmark::kMillisecond)
      ->UseRealTime();
  }
#endif
}

} // namespace

int main(int argc, char** argv)
{
  benchmark::Initialize(&argc, argv);
  const Files files;
  compare<vtkSimplePointsReader>(files, "model.xyz", scan::parsePointsText);
  compare<vtkPLYReader>(files, "model.ply", scan::parsePly);
  compare<vtkOBJReader>(files, "model.obj", scan::parseObj);
  compare<vtkSTLReader>(files, "model.stl", scan::parseStl);
  compare<vtkSTLReader>(files, "ascii.stl", scan::parseStl);
  addOurs(files, "colored.xyz", scan::parsePointsText);
  for (const std::string name : { "colored", "shaded" })
  {
    addOurs(files, name + ".ply", scan::parsePly);
    addOurs(files, name + ".obj", scan::parseObj);
  }
  benchmark::RunSpecifiedBenchmarks();
}
