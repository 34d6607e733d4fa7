// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/points/vtkScanThinFilter.h"

#include "filters/base/vtkScanMeshBridge.h"
#include "filters/geometry/model_length.h"

#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

vtkStandardNewMacro(vtkScanThinFilter);

void vtkScanThinFilter::Run(vtkPolyData& input, vtkPolyData& output, scan::Execution& execution)
{
  execution.plan({ { "neighbours", 1.0 }, { "thin", 2.0 } });
  execution.step("neighbours", 0, 1);
  const std::vector<scan::Vec3> points = scan::bridge::pointsOf(input);
  const std::vector<std::uint8_t> inRegion = this->PointsInRegion(input, execution);
  scan::ThinOptions options = this->Options;
  options.spacing = scan::inModelUnitsOrZero(this->Spacing, points, scan::bridge::unitOf(input));
  scan::bridge::keepPoints(input, scan::thin(points, inRegion, options, execution), output);
  this->PointsBefore = input.GetNumberOfPoints();
  this->PointsAfter = output.GetNumberOfPoints();
  if (this->PointsAfter == this->PointsBefore)
  {
    this->AddNote("nothing changed");
  }
}
