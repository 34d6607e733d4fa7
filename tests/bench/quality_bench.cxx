// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The surfaces of Scanwrap and of CGAL's reconstructions on the same scans: what they are worth,
// time and memory, as the tables of docs/quality.md. Each method runs in a process of its own, on
// one thread, for at most five minutes of processor time.
//
//   quality_bench [--shared=DIR] [--only=SCAN | --out=docs/quality.md]
//
// Without --out the tables go to standard output.

#include "filters/base/error.h"
#include "filters/geometry/spacing.h"
#include "pipeline/peak_memory.h"
#include "readers/mapped_file.h"
#include "readers/ply.h"
#include "tests/bench/quality_tables.h"
#include "tests/readers/temporary_folder.h"
#include "writers/ply.h"

#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <ctime>
#include <fstream>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace
{

namespace fs = std::filesystem;
using quality::Cloud;
using quality::Comparison;
using quality::Method;
using quality::Result;
using quality::ScanSource;
using scan::TriMesh;

constexpr rlim_t kSecondsAllowed = 300;

void writeMesh(const TriMesh& mesh, const fs::path& path)
{
  scan::Execution execution;
  scan::OutputFile file(path.string());
  scan::writePly({ mesh }, {}, file, execution);
  file.commit();
}

TriMesh readMesh(const fs::path& path)
{
  scan::Execution execution;
  const scan::MappedFile file(path.string());
  return scan::parsePly(file.bytes(), file.name(), execution);
}

/// The child: runs one method on the points of the folder.
void reconstruct(const std::string& name, const fs::path& folder)
{
  const auto method = std::find_if(quality::methods().begin(), quality::methods().end(),
    [&](const Method& candidate) { return candidate.name == name; });
  Cloud cloud{ readMesh(folder / "points.ply").points, {} };
  if (fs::exists(folder / "normals.ply"))
  {
    cloud.normals = readMesh(folder / "normals.ply").points;
  }
  const std::clock_t start = std::clock();
  const TriMesh surface = method->reconstruct(cloud);
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  const double megabytes = static_cast<double>(scan::peakMemory()) / 1e6;
  writeMesh(surface, folder / "surface.ply");
  std::ofstream(folder / "cost") << seconds << ' ' << megabytes;
}

/// Runs this program as the child above. The returned text is empty, or says why there is nothing.
std::string runMethod(const Method& method, const fs::path& folder)
{
  const std::string self = fs::read_symlink("/proc/self/exe").string();
  const pid_t child = fork();
  if (child == 0)
  {
    const rlimit seconds{ kSecondsAllowed, kSecondsAllowed + 10 };
    setrlimit(RLIMIT_CPU, &seconds);
    execl(self.c_str(), self.c_str(), "--run", method.name.c_str(), folder.c_str(), nullptr);
    std::_Exit(127);
  }
  int status = 0;
  waitpid(child, &status, 0);
  if (WIFSIGNALED(status))
  {
    return WTERMSIG(status) == SIGXCPU ? fmt::format("over {} s", kSecondsAllowed) : "crashed";
  }
  return WEXITSTATUS(status) == 0 ? "" : "failed";
}

/// One method on one scan.
Result compareMethod(const Method& method, const quality::Scan& scan, double spacing)
{
  const scan::test::TemporaryFolder folder;
  writeMesh({ scan.cloud.points, {} }, folder.file("points.ply"));
  if (!scan.cloud.normals.empty())
  {
    writeMesh({ scan.cloud.normals, {} }, folder.file("normals.ply"));
  }
  Result result;
  result.failure = runMethod(method, folder.file(""));
  if (!result.failure.empty())
  {
    return result;
  }
  const TriMesh surface = readMesh(folder.file("surface.ply"));
  if (surface.triangles.empty())
  {
    result.failure = "no surface";
    return result;
  }
  std::ifstream(folder.file("cost")) >> result.seconds >> result.megabytes;
  const TriMesh* truth = scan.truth ? &*scan.truth : nullptr;
  result.quality = quality::measureQuality(surface, scan.cloud.points, truth, spacing);
  return result;
}

/// All methods on one scan.
Comparison compareScan(const ScanSource& source)
{
  const quality::Scan scan = source.load(source.file);
  Comparison comparison{ source, scan.cloud.points.size(), scan::meanSpacing(scan.cloud.points),
    {} };
  for (const Method& method : quality::methods())
  {
    comparison.results.push_back(compareMethod(method, scan, comparison.spacing));
    fmt::print(
      stderr, "{}: {}", source.name, quality::methodLine(method, comparison.results.back()));
  }
  return comparison;
}

struct Options
{
  fs::path shared = SCAN_SHARED_DIR;
  std::string only;
  fs::path out;
};

Options parse(int argc, char** argv)
{
  Options options;
  for (int i = 1; i < argc; ++i)
  {
    const std::string word(argv[i]);
    const std::string value = word.substr(word.find('=') + 1);
    if (word.starts_with("--shared="))
    {
      options.shared = value;
    }
    else if (word.starts_with("--only="))
    {
      options.only = value;
    }
    else if (word.starts_with("--out="))
    {
      options.out = value;
    }
    else
    {
      throw scan::Error(scan::ErrorCode::badParameter,
        word + ": unknown; use quality_bench [--shared=DIR] [--only=SCAN | --out=FILE]");
    }
  }
  if (!options.only.empty() && !options.out.empty())
  {
    throw scan::Error(scan::ErrorCode::badParameter,
      "--only with --out would drop the tables of the other scans; leave one of them out");
  }
  return options;
}

std::vector<Comparison> compareAll(const Options& options)
{
  std::vector<Comparison> comparisons;
  for (const ScanSource& source : quality::scanSources(options.shared, SCAN_DATA_DIR))
  {
    if (!options.only.empty() && options.only != source.name)
    {
      continue;
    }
    if (!fs::exists(source.file))
    {
      fmt::print(stderr, "{}: skipped, {} is missing\n", source.name, source.file.string());
      continue;
    }
    comparisons.push_back(compareScan(source));
  }
  if (comparisons.empty())
  {
    throw scan::Error(
      scan::ErrorCode::badParameter, "nothing to compare: no scan of this name, or no file");
  }
  return comparisons;
}

} // namespace

int main(int argc, char** argv)
{
  try
  {
    if (argc == 4 && std::string_view(argv[1]) == "--run")
    {
      reconstruct(argv[2], argv[3]);
      return 0;
    }
    const Options options = parse(argc, argv);
    const std::string tables = quality::page(compareAll(options));
    if (options.out.empty())
    {
      fmt::print("{}", tables);
    }
    else
    {
      quality::rewriteTables(options.out, tables);
    }
    return 0;
  }
  catch (const std::exception& error)
  {
    fmt::print(stderr, "quality_bench: {}\n", error.what());
    return 1;
  }
}
