// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/surface/vtkScanRelaxFilter.h"

#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include <utility>

vtkStandardNewMacro(vtkScanRelaxFilter);

std::vector<scan::Phase> vtkScanRelaxFilter::Phases() const
{
  const scan::Phase relax{ "relax", 0.5 };
  return this->Options.featureAngle > 0.0 ? std::vector<scan::Phase>{ { "features", 7.0 }, relax }
                                          : std::vector<scan::Phase>{ relax };
}

scan::SurfaceEdit vtkScanRelaxFilter::Edit(const Surface& surface, scan::Execution& execution)
{
  this->Result = {};
  scan::RelaxOptions options = this->Options;
  options.maxDeviation = surface.maxDeviation;
  const std::vector<std::uint8_t> inRegion = this->PointsInRegion(surface, execution);
  this->Result = scan::relax(surface.mesh, inRegion, options, execution);
  scan::TriMesh moved{ std::move(this->Result.points), surface.mesh.triangles };
  this->Result.points = {};
  return scan::unchanged(std::move(moved));
}
