// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/points/vtkScanNormalsFilter.h"

#include "filters/base/vtkScanMeshBridge.h"

#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

vtkStandardNewMacro(vtkScanNormalsFilter);

void vtkScanNormalsFilter::Run(vtkPolyData& input, vtkPolyData& output, scan::Execution& execution)
{
  execution.plan({ { "neighbours", 1.0 }, { "normals", 2.0 }, { "orient", 2.0 } });
  execution.step("neighbours", 0, 1);
  const std::vector<scan::Vec3> points = scan::bridge::pointsOf(input);
  const std::vector<std::uint8_t> inRegion = this->PointsInRegion(input, execution);
  this->Result = scan::pointNormals(points, this->Options, execution);
  std::vector<scan::Vec3> normals = scan::bridge::normalsOf(input);
  normals.resize(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    normals[i] = inRegion[i] != 0 ? this->Result.normals[i] : normals[i];
  }
  this->Result.normals = {};
  scan::bridge::movePoints(input, points, output);
  scan::bridge::setNormals(output, normals);
  if (this->Result.openParts > 0)
  {
    this->AddNote(std::to_string(this->Result.openParts) + " of " +
      std::to_string(this->Result.parts) +
      " connected parts have no inside; their normals point up");
  }
}
