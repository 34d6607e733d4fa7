// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Operations on surfaces beside those of CGAL and VTK, in turn, in seconds by the clock and of the
// processors: a bumpy knot. Each run is a process of its own, for its memory.
//
//   surface_bench [WORD] [TRIANGLES] [THREADS]      default: all 1000000 1
//
// WORD is one of the names at the end of this file.

#include "filters/geometry/hilbert_order.h"
#include "filters/geometry/self_intersections.h"
#include "filters/geometry/surface_deviation.h"
#include "filters/geometry/triangle_tree.h"
#include "pipeline/peak_memory.h"
#include "tests/bench/knot_scan.h"
#include "tests/bench/vtk_surface.h"

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <tbb/global_control.h>
#include <vtkGenericCell.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkStaticCellLocator.h>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace
{

using namespace scan;
using bench::knotSurface;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

/// What a comparison works on.
struct Task
{
  std::size_t triangles = 0;
  unsigned threads = 1;
};

double secondsOfProcessors()
{
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  const auto seconds = [](const timeval& time)
  { return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec); };
  return seconds(used.ru_utime) + seconds(used.ru_stime);
}

/// Runs in a process of its own, so that the peak is that of the run alone. Of three runs the
/// fastest counts. What `run` returns is printed.
void measure(const Task& task, const char* name, const std::function<std::string()>& run)
{
  std::fflush(stdout);
  const pid_t child = fork();
  if (child != 0)
  {
    waitpid(child, nullptr, 0);
    return;
  }
  const tbb::global_control limit(
    tbb::global_control::max_allowed_parallelism, std::max(1U, task.threads));
  double seconds = 1e30;
  double ofProcessors = 1e30;
  std::string result;
  for (int i = 0; i < 3; ++i)
  {
    const auto start = std::chrono::steady_clock::now();
    const double startOfProcessors = secondsOfProcessors();
    result = run();
    seconds = std::min(
      seconds, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    ofProcessors = std::min(ofProcessors, secondsOfProcessors() - startOfProcessors);
  }
  std::printf("%-40s %7.3f s  %7.3f s CPU  %6.0f MB  %s\n", name, seconds, ofProcessors,
    static_cast<double>(peakMemory()) / 1e6, result.c_str());
  std::fflush(stdout);
  _exit(0);
}

/// The knot with about so many triangles.
TriMesh knotOf(std::size_t triangles)
{
  const auto around = static_cast<Index>(std::sqrt(static_cast<double>(triangles) / 16.0));
  return knotSurface(8 * around, around);
}

template <class Surface>
Surface cgalSurface(const TriMesh& mesh)
{
  Surface surface;
  for (const Vec3& p : mesh.points)
  {
    surface.add_vertex({ p.x, p.y, p.z });
  }
  for (const auto& [a, b, c] : mesh.triangles)
  {
    using Vertex = typename Surface::Vertex_index;
    surface.add_face(Vertex(a), Vertex(b), Vertex(c));
  }
  return surface;
}

std::string meanOf(double sum, std::size_t count)
{
  return "mean " + std::to_string(sum / static_cast<double>(count));
}

/// The distances of as many points, along a curve, on one thread; with the search structure.
void compareNearest(const Task& task)
{
  const TriMesh mesh = knotOf(task.triangles);
  std::vector<Vec3> points = bench::knotScan(task.triangles);
  Execution run(1);
  std::vector<Vec3> sorted;
  for (const Index i : hilbertOrder(points, run))
  {
    sorted.push_back(points[i]);
  }
  points.swap(sorted);
  measure(task, "TriangleTree",
    [&]
    {
      const TriangleTree tree(mesh, run);
      double sum = 0.0;
      Index hint = kNone;
      for (const Vec3& p : points)
      {
        const SurfacePlace place = tree.nearest(p, hint);
        hint = place.triangle;
        sum += std::sqrt(place.squaredDistance);
      }
      return meanOf(sum, points.size());
    });
  measure(task, "TriangleTree, the tree alone",
    [&]
    {
      const TriangleTree tree(mesh, run);
      return std::string();
    });
  using Simple = CGAL::Simple_cartesian<double>;
  using Surface = CGAL::Surface_mesh<Simple::Point_3>;
  using Primitive = CGAL::AABB_face_graph_triangle_primitive<Surface>;
  const Surface theirs = cgalSurface<Surface>(mesh);
  measure(task, "CGAL AABB_tree",
    [&]
    {
      CGAL::AABB_tree<CGAL::AABB_traits<Simple, Primitive>> tree(
        faces(theirs).first, faces(theirs).second, theirs);
      tree.accelerate_distance_queries();
      double sum = 0.0;
      for (const Vec3& p : points)
      {
        sum += std::sqrt(tree.squared_distance({ p.x, p.y, p.z }));
      }
      return meanOf(sum, points.size());
    });
  const vtkNew<vtkPolyData> surface = bench::vtkSurface(mesh);
  measure(task, "vtkStaticCellLocator",
    [&]
    {
      vtkNew<vtkStaticCellLocator> locator;
      locator->SetDataSet(surface);
      locator->BuildLocator();
      vtkNew<vtkGenericCell> cell;
      double sum = 0.0;
      for (const Vec3& p : points)
      {
        const std::array<double, 3> from{ p.x, p.y, p.z };
        std::array<double, 3> nearest{};
        vtkIdType triangle = 0;
        int part = 0;
        double squared = 0.0;
        locator->FindClosestPoint(from.data(), nearest.data(), cell, triangle, part, squared);
        sum += std::sqrt(squared);
      }
      return meanOf(sum, points.size());
    });
}

/// The pairs of triangles in each other's way: of the knot, where there are none, and of two.
void compareSelfIntersections(const Task& task)
{
  const TriMesh clean = knotOf(task.triangles);
  TriMesh crossed = knotOf(task.triangles / 2);
  const auto half = static_cast<Index>(crossed.points.size());
  const std::size_t triangles = crossed.triangles.size();
  for (Index i = 0; i < half; ++i)
  {
    crossed.points.push_back(crossed.points[i] + Vec3{ 1.3, 0.7, 0.4 });
  }
  for (std::size_t t = 0; t < triangles; ++t)
  {
    const auto [a, b, c] = crossed.triangles[t];
    crossed.triangles.push_back({ half + a, half + b, half + c });
  }
  const auto compare = [&](const char* name, const TriMesh& mesh)
  {
    std::printf("%s\n", name);
    measure(task, "selfIntersections",
      [&]
      {
        Execution run(task.threads);
        return std::to_string(selfIntersections(mesh, run).size()) + " pairs";
      });
    using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
    const auto theirs = cgalSurface<Surface>(mesh);
    measure(task, "CGAL self_intersections",
      [&]
      {
        std::vector<std::pair<Surface::Face_index, Surface::Face_index>> found;
        CGAL::Polygon_mesh_processing::self_intersections(theirs, std::back_inserter(found));
        return std::to_string(found.size()) + " pairs";
      });
  };
  compare("clean", clean);
  compare("crossed", crossed);
}

/// A surface from one of a tenth of the triangles, and back. There is nothing to compare it with:
/// others take samples.
void measureDeviation(const Task& task)
{
  const TriMesh fine = knotOf(task.triangles);
  const TriMesh coarse = knotOf(task.triangles / 10);
  const auto measureFrom = [&](const char* name, const TriMesh& from, const TriMesh& to)
  {
    measure(task, name,
      [&]
      {
        Execution run(task.threads);
        const TriangleTree tree(to, run);
        const SurfaceDeviation deviation = deviationFrom(from, tree, run);
        return "largest " + std::to_string(deviation.largest) + ", at most " +
          std::to_string(deviation.atMost);
      });
  };
  measureFrom("deviationFrom, fine from coarse", fine, coarse);
  measureFrom("deviationFrom, coarse from fine", coarse, fine);
}

const std::vector<std::pair<std::string, void (*)(const Task&)>> kComparisons = {
  { "nearest", compareNearest },
  { "self-intersections", compareSelfIntersections },
  { "deviation", measureDeviation },
};

} // namespace

int main(int argc, char** argv)
{
  const std::string word = argc > 1 ? argv[1] : "all";
  const Task task{ argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1000000,
    static_cast<unsigned>(argc > 3 ? std::atoi(argv[3]) : 1) };
  for (const auto& [name, compare] : kComparisons)
  {
    if (word == name || word == "all")
    {
      std::printf("%s: %zu triangles, %u threads\n", name.c_str(), task.triangles, task.threads);
      compare(task);
    }
  }
}
