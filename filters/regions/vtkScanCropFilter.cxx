// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/regions/vtkScanCropFilter.h"

#include "filters/base/vtkScanMeshBridge.h"
#include "filters/base/vtkScanRegions.h"

#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

vtkStandardNewMacro(vtkScanCropFilter);

void vtkScanCropFilter::Run(vtkPolyData& input, vtkPolyData& output, scan::Execution& execution)
{
  execution.plan({ { "choose", 1.0 } });
  execution.step("choose", 0, 1);
  if (this->GetRegion().empty())
  {
    throw scan::Error(scan::ErrorCode::badParameter,
      "--region: expected the name of a region, or a rule such as sphere(0,0,0,5)");
  }
  scan::bridge::keepRegion(input, this->GetRegion(), !this->Erase, output, execution);
  this->PointsGone = input.GetNumberOfPoints() - output.GetNumberOfPoints();
  this->TrianglesGone =
    scan::bridge::triangleCountOf(input) - scan::bridge::triangleCountOf(output);
  if (output.GetNumberOfPoints() == 0)
  {
    this->AddNote("nothing is left");
  }
  else if (this->PointsGone + this->TrianglesGone == 0)
  {
    this->AddNote("nothing changed");
  }
  execution.step("choose", 1, 1);
}
