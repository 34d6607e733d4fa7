// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/points/vtkScanDenoiseFilter.h"

#include "filters/base/vtkScanMeshBridge.h"
#include "filters/geometry/model_length.h"

#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

vtkStandardNewMacro(vtkScanDenoiseFilter);

void vtkScanDenoiseFilter::Run(vtkPolyData& input, vtkPolyData& output, scan::Execution& execution)
{
  execution.plan({ { "denoise", 1.0 } });
  execution.step("denoise", 0, 1);
  const std::vector<scan::Vec3> points = scan::bridge::pointsOf(input);
  const std::vector<std::uint8_t> inRegion = this->PointsInRegion(input, execution);
  this->Limit = scan::inModelUnitsOrZero(this->MaxShift, points, scan::bridge::unitOf(input));
  scan::DenoiseOptions options = this->Options;
  options.maxShift = this->Limit;
  this->Result = scan::denoise(points, inRegion, options, execution);
  scan::bridge::movePoints(input, this->Result.points, output);
  this->Result.points = {};
  if (this->Result.moved == 0)
  {
    this->AddNote("nothing changed");
  }
}
