// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/surface/vtkScanBridgeFilter.h"

#include "filters/base/error.h"

#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include <utility>

vtkStandardNewMacro(vtkScanBridgeFilter);

std::vector<scan::Phase> vtkScanBridgeFilter::Phases() const
{
  return { { "bridge", 1.0 } };
}

scan::SurfaceEdit vtkScanBridgeFilter::Edit(const Surface& surface, scan::Execution& execution)
{
  if (!this->HasFrom || !this->HasTo)
  {
    throw scan::Error(scan::ErrorCode::badParameter,
      "a bridge needs two places: name them with --from=x,y,z and --to=x,y,z");
  }
  scan::BridgeOptions options = this->Options;
  options.maxDeviation = surface.maxDeviation;
  const std::vector<std::uint8_t> inRegion = this->PointsInRegion(surface, execution);
  this->Result = scan::bridge(surface.mesh, inRegion, options, execution);
  return std::exchange(this->Result.edit, {});
}
