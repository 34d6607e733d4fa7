// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Decimation beside VTK's quadric decimation and OpenMesh's decimater, in turn: processor seconds,
// and how far the results are from the surface, as bounds on the distance both ways.
//
//   decimate_bench            the knot of a million triangles, to 50, 10, 5 and 1 %
//   decimate_bench FILE.ply   another surface
//   decimate_bench --openmesh [FILE.ply]   OpenMesh, too, which takes long

#include "filters/base/vtkScanMeshBridge.h"
#include "filters/geometry/mesh_checks.h"
#include "filters/geometry/openmesh_decimate.h"
#include "filters/geometry/self_intersections.h"
#include "filters/geometry/surface_deviation.h"
#include "readers/mapped_file.h"
#include "readers/ply.h"
#include "tests/bench/knot_scan.h"

#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkQuadricDecimation.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <functional>
#include <limits>
#include <string>

namespace
{

using namespace scan;

struct Run
{
  TriMesh mesh;
  double seconds = std::numeric_limits<double>::infinity(); ///< of the processor, the best run
};

Run measure(int runs, const std::function<TriMesh()>& run)
{
  Run result;
  for (int i = 0; i < runs; ++i)
  {
    const std::clock_t start = std::clock();
    result.mesh = run();
    const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    result.seconds = std::min(result.seconds, seconds);
  }
  return result;
}

TriMesh decimateByVtk(vtkPolyData& data, double ratio)
{
  vtkNew<vtkQuadricDecimation> filter;
  filter->SetInputData(&data);
  filter->SetTargetReduction(1.0 - ratio);
  filter->Update();
  return bridge::meshOf(*filter->GetOutput());
}

struct Errors
{
  double mean = 0.0;    ///< of both ways
  double largest = 0.0; ///< of both ways
};

Errors errorsOf(const TriMesh& before, const TriangleTree& beforeTree, const TriMesh& after)
{
  Execution execution;
  const TriangleTree afterTree(after, execution);
  const SurfaceDeviation there = deviationFrom(before, afterTree, execution);
  const SurfaceDeviation back = deviationFrom(after, beforeTree, execution);
  return { (there.mean + back.mean) / 2.0, std::max(there.atMost, back.atMost) };
}

void print(const char* name, const Run& run, const Errors& errors, const Run& other,
  const Errors& otherErrors)
{
  Execution execution;
  const MeshReport report = describeMesh(run.mesh);
  std::printf("  %-10s %8zu triangles %8.3f s (%5.1f times)  mean %.3e (%.3f)  largest %.3e "
              "(%.3f)  %s, %zu self-intersections\n",
    name, run.mesh.triangles.size(), run.seconds, other.seconds / run.seconds, errors.mean,
    errors.mean / otherErrors.mean, errors.largest, errors.largest / otherErrors.largest,
    report.isManifold ? "manifold" : "NOT manifold", selfIntersections(run.mesh, execution).size());
}

void compare(const TriMesh& mesh, double ratio, bool withOpenMesh)
{
  Execution oneThread(1);
  DecimateOptions options;
  options.triangles = static_cast<std::size_t>(ratio * static_cast<double>(mesh.triangles.size()));
  vtkNew<vtkPolyData> data;
  bridge::setMesh(*data, mesh);
  const TriangleTree tree(mesh, oneThread);
  std::printf("to %g %%\n", 100.0 * ratio);
  const Run vtk = measure(1, [&] { return decimateByVtk(*data, ratio); });
  const Errors vtkErrors = errorsOf(mesh, tree, vtk.mesh);
  print("VTK", vtk, vtkErrors, vtk, vtkErrors);
  if (withOpenMesh)
  {
    const Run run =
      measure(1, [&] { return decimateByOpenMesh(mesh, options, {}, oneThread).edit.mesh; });
    print("OpenMesh", run, errorsOf(mesh, tree, run.mesh), vtk, vtkErrors);
  }
  const Run own = measure(3, [&] { return decimate(mesh, options, oneThread).edit.mesh; });
  print("scanwrap", own, errorsOf(mesh, tree, own.mesh), vtk, vtkErrors);
}

} // namespace

int main(int argc, char** argv)
{
  const bool withOpenMesh = argc > 1 && std::strcmp(argv[1], "--openmesh") == 0;
  const char* const file = argc > (withOpenMesh ? 2 : 1) ? argv[argc - 1] : nullptr;
  TriMesh mesh = bench::knotSurface(2000, 250);
  if (file != nullptr)
  {
    const MappedFile bytes(file);
    Execution execution;
    mesh = parsePly(bytes.bytes(), file, execution);
  }
  for (const double ratio : { 0.5, 0.1, 0.05, 0.01 })
  {
    compare(mesh, ratio, withOpenMesh);
  }
  return 0;
}
