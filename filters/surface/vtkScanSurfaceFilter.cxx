// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/surface/vtkScanSurfaceFilter.h"

#include "filters/base/vtkScanMeshBridge.h"
#include "filters/geometry/model_length.h"
#include "filters/surface/surface_data.h"

#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{

/// Of two surfaces both ways.
scan::SurfaceDeviation deviationBetween(
  const scan::TriMesh& before, const scan::TriMesh& after, scan::Execution& execution)
{
  const scan::TriangleTree beforeTree(before, execution);
  const scan::TriangleTree afterTree(after, execution);
  const auto there = scan::deviationFrom(before, afterTree, execution);
  execution.step("measure", 1, 2);
  const auto back = scan::deviationFrom(after, beforeTree, execution);
  scan::SurfaceDeviation both = there.largest >= back.largest ? there : back;
  both.mean = (there.mean + back.mean) / 2.0;
  both.rms = std::hypot(there.rms, back.rms) / std::sqrt(2.0);
  both.atMost = std::max(there.atMost, back.atMost);
  return both;
}

bool isSame(const scan::TriMesh& a, const scan::TriMesh& b)
{
  return a.points == b.points && a.triangles == b.triangles;
}

} // namespace

std::vector<std::uint8_t> vtkScanSurfaceFilter::PointsInRegion(
  const Surface& surface, scan::Execution& execution) const
{
  return this->GetRegion().empty() ? std::vector<std::uint8_t>(surface.mesh.points.size(), 1)
                                   : this->Superclass::PointsInRegion(surface.data, execution);
}

std::vector<std::uint8_t> vtkScanSurfaceFilter::TrianglesInRegion(
  const Surface& surface, scan::Execution& execution) const
{
  return this->GetRegion().empty() ? std::vector<std::uint8_t>(surface.mesh.triangles.size(), 1)
                                   : this->Superclass::TrianglesInRegion(surface.data, execution);
}

double vtkScanSurfaceFilter::InModelUnits(const scan::Length& length, const Surface& surface)
{
  return scan::inModelUnitsOrZero(length, surface.mesh.points, scan::bridge::unitOf(surface.data));
}

void vtkScanSurfaceFilter::Finish(vtkPolyData&) {}

void vtkScanSurfaceFilter::Run(vtkPolyData& input, vtkPolyData& output, scan::Execution& execution)
{
  std::vector<scan::Phase> phases = this->Phases();
  const std::string first = phases.front().name;
  if (this->Measure)
  {
    phases.push_back({ "measure", 1.0 });
  }
  execution.plan(std::move(phases));
  execution.step(first, 0, 1);

  std::vector<vtkIdType> cells;
  const scan::TriMesh mesh = scan::bridge::meshOf(input, &cells);
  this->Deviation.reset();
  this->TrianglesBefore = static_cast<vtkIdType>(mesh.triangles.size());
  this->TrianglesAfter = 0;
  if (mesh.triangles.empty())
  {
    throw scan::Error(scan::ErrorCode::badInput, "there is no surface yet; wrap the points first");
  }
  Surface surface{ mesh, cells, input, std::numeric_limits<double>::infinity() };
  if (this->MaxDeviation.value() > 0.0)
  {
    surface.maxDeviation = InModelUnits(this->MaxDeviation, surface);
  }
  const scan::SurfaceEdit edit = this->Edit(surface, execution);
  this->TrianglesAfter = static_cast<vtkIdType>(edit.mesh.triangles.size());
  const bool stays = isSame(mesh, edit.mesh);
  if (stays)
  {
    this->AddNote("nothing changed");
  }
  if (this->Measure)
  {
    execution.step("measure", 0, 2);
    if (!edit.mesh.triangles.empty())
    {
      this->Deviation =
        stays ? scan::SurfaceDeviation() : deviationBetween(mesh, edit.mesh, execution);
    }
    execution.step("measure", 2, 2);
  }
  scan::setSurface(input, edit, cells, output);
  scan::bridge::passOrigin(input, output);
  this->Finish(output);
}
