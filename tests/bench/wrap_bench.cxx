// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Whole runs of `scanwrap FILE wrap -o FILE` against the bare Delaunay triangulation of CGAL on the
// same points and as many threads, in turn, in one run: seconds, ratio, peak memory, growth.
//
//   wrap_bench [--runs=N] [--threads=N] [POINTS ...]
//   default: 3 runs; one thread and two; 200000 1000000 3000000

#include "tests/bench/knot_scan.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace
{

namespace fs = std::filesystem;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;

double now()
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

void writePoints(const fs::path& file, const std::vector<scan::Vec3>& points)
{
  std::FILE* out = std::fopen(file.c_str(), "w");
  for (const scan::Vec3& p : points)
  {
    std::fprintf(out, "%.6f %.6f %.6f\n", p.x, p.y, p.z);
  }
  std::fclose(out);
}

std::vector<Point> readPoints(const char* file)
{
  std::vector<Point> points;
  std::FILE* in = std::fopen(file, "r");
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
  while (std::fscanf(in, "%lf %lf %lf", &x, &y, &z) == 3) // NOLINT(cert-err34-c): our own file
  {
    points.emplace_back(x, y, z);
  }
  std::fclose(in);
  return points;
}

/// The rival, in a process of its own: seconds for the triangulation alone, on standard output.
int triangulateBare(const char* file, int threads)
{
  const std::vector<Point> points = readPoints(file);
  const double start = now();
  std::size_t cells = 0;
  if (threads == 1)
  {
    cells =
      CGAL::Delaunay_triangulation_3<Kernel>(points.begin(), points.end()).number_of_finite_cells();
  }
  else
  {
    using Structure =
      CGAL::Triangulation_data_structure_3<CGAL::Triangulation_vertex_base_3<Kernel>,
        CGAL::Delaunay_triangulation_cell_base_3<Kernel>, CGAL::Parallel_tag>;
    using Parallel = CGAL::Delaunay_triangulation_3<Kernel, Structure>;
    constexpr int kLocks = 50; // an axis, as in CGAL's own benchmark
    tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    Parallel::Lock_data_structure locks(CGAL::bbox_3(points.begin(), points.end()), kLocks);
    cells = Parallel(points.begin(), points.end(), &locks).number_of_finite_cells();
  }
  std::printf("%.6f\n", now() - start);
  return cells > 0 ? 0 : 1;
}

struct Run
{
  double seconds = 0.0; ///< wall clock of the process, or what it printed
  double megabytes = 0.0;
};

/// Runs a program to its end. When it prints a number, that is its time.
Run runProcess(const std::vector<std::string>& command)
{
  std::array<int, 2> pipe{};
  if (::pipe(pipe.data()) != 0)
  {
    std::perror("pipe");
    std::exit(1);
  }
  const double start = now();
  const pid_t child = fork();
  if (child == 0)
  {
    dup2(pipe[1], STDOUT_FILENO);
    close(pipe[0]);
    close(pipe[1]);
    std::vector<char*> arguments;
    for (const std::string& word : command)
    {
      arguments.push_back(const_cast<char*>(word.c_str()));
    }
    arguments.push_back(nullptr);
    execv(arguments[0], arguments.data());
    std::_Exit(127);
  }
  close(pipe[1]);
  std::string printed;
  std::array<char, 256> buffer{};
  for (ssize_t n = 0; (n = read(pipe[0], buffer.data(), buffer.size())) > 0;)
  {
    printed.append(buffer.data(), static_cast<std::size_t>(n));
  }
  close(pipe[0]);
  int status = 0;
  rusage usage{};
  wait4(child, &status, 0, &usage);
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
  {
    std::fprintf(stderr, "%s failed\n", command[0].c_str());
    std::exit(1);
  }
  const double told = std::strtod(printed.c_str(), nullptr);
  return { told > 0.0 ? told : now() - start, static_cast<double>(usage.ru_maxrss) / 1024.0 };
}

/// Median seconds and largest memory of several runs.
Run summary(std::vector<Run> runs)
{
  std::sort(
    runs.begin(), runs.end(), [](const Run& a, const Run& b) { return a.seconds < b.seconds; });
  Run result = runs[runs.size() / 2];
  for (const Run& run : runs)
  {
    result.megabytes = std::max(result.megabytes, run.megabytes);
  }
  return result;
}

struct Options
{
  int runs = 3;
  int threads = 2;
  std::vector<std::size_t> sizes;
};

Options parse(int argc, char** argv)
{
  Options options;
  for (int i = 1; i < argc; ++i)
  {
    const std::string_view word(argv[i]);
    if (word.starts_with("--runs="))
    {
      options.runs = std::max(1, std::atoi(argv[i] + 7)); // NOLINT(cert-err34-c)
    }
    else if (word.starts_with("--threads="))
    {
      options.threads = std::max(2, std::atoi(argv[i] + 10)); // NOLINT(cert-err34-c)
    }
    else
    {
      options.sizes.push_back(std::strtoull(argv[i], nullptr, 10));
    }
  }
  if (options.sizes.empty())
  {
    options.sizes = { 200'000, 1'000'000, 3'000'000 };
  }
  return options;
}

/// A command on some threads, and the runs that it has had.
struct Contestant
{
  std::string name;
  std::vector<std::string> command;
  std::vector<Run> runs;
};

/// The rival first, then the modes of wrap, on as many threads.
std::vector<Contestant> contestants(int threads, const std::string& scan, const std::string& mesh)
{
  const fs::path self = fs::read_symlink("/proc/self/exe");
  const std::string scanwrap = self.parent_path() / "scanwrap";
  const std::string count = std::to_string(threads);
  const auto wrap = [&](const std::string& mode)
  {
    return Contestant{ "wrap --mode=" + mode + ", " + count,
      { scanwrap, scan, "--quiet", "--overwrite", "--threads=" + count, "wrap", "--mode=" + mode,
        "-o", mesh },
      {} };
  };
  return { { "CGAL Delaunay, bare, " + count, { self, "--bare", scan, count }, {} },
    wrap("classic"), wrap("auto") };
}

void benchmark(const Options& options, const fs::path& folder)
{
  const std::string scan = folder / "scan.xyz";
  std::printf("%9s  %-24s %9s %7s %9s %12s\n", "points", "run, threads", "seconds", "ratio",
    "peak MB", "us a point");
  for (const std::size_t size : options.sizes)
  {
    writePoints(scan, scan::bench::knotScan(size));
    std::vector<std::vector<Contestant>> groups{ contestants(1, scan, folder / "mesh.stl"),
      contestants(options.threads, scan, folder / "mesh.stl") };
    for (int run = 0; run < options.runs; ++run) // in turn, so that a slow spell hits all alike
    {
      for (auto& group : groups)
      {
        for (Contestant& contestant : group)
        {
          contestant.runs.push_back(runProcess(contestant.command));
        }
      }
    }
    for (const auto& group : groups)
    {
      const double rival = summary(group.front().runs).seconds;
      for (const Contestant& contestant : group)
      {
        const Run run = summary(contestant.runs);
        std::printf("%9zu  %-24s %9.2f %7.2f %9.0f %12.2f\n", size, contestant.name.c_str(),
          run.seconds, run.seconds / rival, run.megabytes,
          1e6 * run.seconds / static_cast<double>(size));
      }
    }
    std::fflush(stdout);
  }
}

} // namespace

int main(int argc, char** argv)
{
  if (argc == 4 && std::strcmp(argv[1], "--bare") == 0)
  {
    return triangulateBare(argv[2], std::atoi(argv[3])); // NOLINT(cert-err34-c): our own word
  }
  std::string folder = (fs::temp_directory_path() / "wrap_bench_XXXXXX").string();
  if (mkdtemp(folder.data()) == nullptr)
  {
    std::perror("mkdtemp");
    return 1;
  }
  benchmark(parse(argc, argv), folder);
  fs::remove_all(folder);
  return 0;
}
