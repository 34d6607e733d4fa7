// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later

// relax beside vtkWindowedSincPolyDataFilter on one thread, in turn, 50 iterations each (ours are
// pairs of steps), on a closed mesh of a million triangles. The best of several runs, in seconds.
// VTK_SMP_MAX_THREADS=2 in the environment gives VTK two threads.
//
//   relax_bench [RUNS]      default: 5

#include "filters/geometry/relax.h"
#include "tests/bench/knot_scan.h"
#include "tests/bench/vtk_surface.h"

#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkWindowedSincPolyDataFilter.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>

namespace
{

using namespace scan;

constexpr int kIterations = 50;

/// The best times so far.
struct Best
{
  double wall = 1e9;
  double processor = 1e9; ///< of all threads

  void measure(const std::function<void()>& run)
  {
    const auto start = std::chrono::steady_clock::now();
    const std::clock_t before = std::clock();
    run();
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
    this->wall = std::min(this->wall, passed.count());
    this->processor =
      std::min(this->processor, static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC);
  }
};

} // namespace

int main(int argc, char** argv)
{
  setenv("VTK_SMP_MAX_THREADS", "1", 0);
  const int runs = argc > 1 ? std::atoi(argv[1]) : 5;
  const TriMesh mesh = bench::knotSurface(2000, 250);
  const std::vector<std::uint8_t> everywhere(mesh.points.size(), 1);
  const vtkNew<vtkPolyData> data = bench::vtkSurface(mesh);
  Best vtk;
  Best one;
  Best two;
  for (int run = 0; run < runs; ++run)
  {
    vtk.measure(
      [&]
      {
        vtkNew<vtkWindowedSincPolyDataFilter> filter;
        filter->SetInputData(data);
        filter->SetNumberOfIterations(kIterations);
        filter->BoundarySmoothingOff();
        filter->Update();
      });
    for (const unsigned threads : { 1U, 2U })
    {
      (threads == 1 ? one : two)
        .measure(
          [&]
          {
            Execution execution(threads);
            relax(mesh, everywhere, { .iterations = kIterations }, execution);
          });
    }
  }
  std::printf(
    "%zu triangles, %d iterations, best of %d runs\n", mesh.triangles.size(), kIterations, runs);
  std::printf("                          wall  processor\n");
  std::printf("vtkWindowedSinc         %6.3f %10.3f s\n", vtk.wall, vtk.processor);
  std::printf("relax, 1 thread         %6.3f %10.3f s   %.2f times faster (processor %.2f)\n",
    one.wall, one.processor, vtk.wall / one.wall, vtk.processor / one.processor);
  std::printf("relax, 2 threads        %6.3f %10.3f s   %.2f times faster\n", two.wall,
    two.processor, vtk.wall / two.wall);
}
