// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Operations on points beside those of CGAL, in turn, in seconds: a noisy torus in random order.
// CGAL runs on all threads, too, where it can. Each run is a process of its own, for its memory.
//
//   points_bench [POINTS] [THREADS]      default: 1000000 2

#include "filters/geometry/denoise.h"
#include "filters/geometry/outliers.h"
#include "filters/geometry/point_normals.h"
#include "filters/geometry/random.h"
#include "filters/geometry/thin.h"
#include "pipeline/peak_memory.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/grid_simplify_point_set.h>
#include <CGAL/jet_smooth_point_set.h>
#include <CGAL/mst_orient_normals.h>
#include <CGAL/pca_estimate_normals.h>
#include <CGAL/property_map.h>
#include <CGAL/remove_outliers.h>
#include <tbb/global_control.h>

#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <numbers>
#include <vector>

namespace
{

using namespace scan;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using PointWithNormal = std::pair<Point, Kernel::Vector_3>;
using PointMap = CGAL::First_of_pair_property_map<PointWithNormal>;
using NormalMap = CGAL::Second_of_pair_property_map<PointWithNormal>;

std::vector<Vec3> noisyTorus(std::size_t count)
{
  using std::numbers::pi;
  constexpr double kTube = 0.35;
  Random random(1);
  std::vector<Vec3> points;
  while (points.size() < count)
  {
    const double u = 2.0 * pi * random.unit();
    const double v = 2.0 * pi * random.unit();
    const double r = 1.0 + kTube * std::cos(v);
    if (random.unit() * (1.0 + kTube) < r)
    {
      const double noise = 1.0 + 0.001 * (random.unit() - 0.5);
      points.push_back(Vec3{ r * std::cos(u), r * std::sin(u), kTube * std::sin(v) } * noise);
    }
  }
  return points;
}

/// Runs in a process of its own, so that the peak is that of the run alone.
void measure(const char* name, const std::function<void()>& run)
{
  std::fflush(stdout);
  const pid_t child = fork();
  if (child != 0)
  {
    waitpid(child, nullptr, 0);
    return;
  }
  const auto start = std::chrono::steady_clock::now();
  run();
  const double seconds =
    std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  std::printf("%-36s %7.2f s  %6.0f MB\n", name, seconds, static_cast<double>(peakMemory()) / 1e6);
  std::fflush(stdout);
  _exit(0);
}

} // namespace

int main(int argc, char** argv)
{
  const std::size_t count = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 1000000;
  const auto threads = static_cast<unsigned>(argc > 2 ? std::atoi(argv[2]) : 2);
  const std::vector<Vec3> points = noisyTorus(count);
  std::vector<PointWithNormal> theirs;
  for (const Vec3& p : points)
  {
    theirs.emplace_back(Point(p.x, p.y, p.z), Kernel::Vector_3(0, 0, 0));
  }
  const std::vector<std::uint8_t> everywhere(count, 1);
  const double spacing =
    std::sqrt(4.0 * std::pow(std::numbers::pi, 2) * 0.35 / static_cast<double>(count));
  const auto parameters = CGAL::parameters::point_map(PointMap()).normal_map(NormalMap());
  const auto ours = [&](const char* name, const std::function<void(Execution&)>& run)
  {
    measure(name,
      [&]
      {
        Execution execution(threads);
        run(execution);
      });
  };
  const auto cgal = [&](const char* name, const std::function<void()>& run)
  {
    measure(name,
      [&]
      {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        run();
      });
  };
  std::printf("%zu points, %u threads\n", count, threads);
  measure("nothing, for the memory", [] {});
  ours("thin --by=grid",
    [&](Execution& execution) {
      thin(points, everywhere, { .by = ThinOptions::By::grid, .spacing = 2 * spacing }, execution);
    });
  cgal(
    "CGAL grid_simplify", [&] { CGAL::grid_simplify_point_set(theirs, 2 * spacing, parameters); });
  ours("thin --by=spacing",
    [&](Execution& execution) { thin(points, everywhere, { .spacing = 2 * spacing }, execution); });
  ours("thin --by=curvature",
    [&](Execution& execution)
    { thin(points, everywhere, { .by = ThinOptions::By::curvature }, execution); });
  ours("remove-outliers",
    [&](Execution& execution) { findOutliers(points, everywhere, {}, execution); });
  cgal("CGAL remove_outliers, 16 neighbours",
    [&] { CGAL::remove_outliers<CGAL::Parallel_if_available_tag>(theirs, 16, parameters); });
  ours("denoise, 1 iteration",
    [&](Execution& execution)
    { denoise(points, everywhere, { .maxShift = spacing, .iterations = 1 }, execution); });
  cgal("CGAL jet_smooth, 32 neighbours",
    [&] { CGAL::jet_smooth_point_set<CGAL::Parallel_if_available_tag>(theirs, 32, parameters); });
  ours("normals", [&](Execution& execution) { pointNormals(points, {}, execution); });
  cgal("CGAL pca_estimate + mst_orient, 16",
    [&]
    {
      CGAL::pca_estimate_normals<CGAL::Parallel_if_available_tag>(theirs, 16, parameters);
      CGAL::mst_orient_normals(theirs, 16, parameters);
    });
}
