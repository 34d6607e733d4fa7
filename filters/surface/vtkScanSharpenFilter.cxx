// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/surface/vtkScanSharpenFilter.h"

#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include <utility>

vtkStandardNewMacro(vtkScanSharpenFilter);

std::vector<scan::Phase> vtkScanSharpenFilter::Phases() const
{
  return { { "sharpen", 1.0 }, { "check", 2.0 } };
}

scan::SurfaceEdit vtkScanSharpenFilter::Edit(const Surface& surface, scan::Execution& execution)
{
  this->Options.maxDeviation = surface.maxDeviation;
  this->Result = scan::sharpen(
    surface.mesh, this->TrianglesInRegion(surface, execution), this->Options, execution);
  return std::exchange(this->Result.edit, {});
}
