// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/points/vtkScanRemoveOutliersFilter.h"

#include "filters/base/vtkScanMeshBridge.h"

#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include <algorithm>

vtkStandardNewMacro(vtkScanRemoveOutliersFilter);

void vtkScanRemoveOutliersFilter::Run(
  vtkPolyData& input, vtkPolyData& output, scan::Execution& execution)
{
  execution.plan({ { "neighbours", 1.0 }, { "outliers", 3.0 } });
  execution.step("neighbours", 0, 1);
  const std::vector<scan::Vec3> points = scan::bridge::pointsOf(input);
  this->Result =
    scan::findOutliers(points, this->PointsInRegion(input, execution), this->Options, execution);
  std::vector<std::uint8_t> isKept(points.size());
  std::ranges::transform(this->Result.isStray, isKept.begin(),
    [](std::uint8_t isStray) { return isStray != 0 ? 0 : 1; });
  scan::bridge::keepPoints(input, isKept, output);
  if (this->Result.single + this->Result.together == 0)
  {
    this->AddNote("no stray points found");
  }
}
