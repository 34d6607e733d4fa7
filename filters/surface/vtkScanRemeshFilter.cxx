// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/surface/vtkScanRemeshFilter.h"

#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include <string>
#include <utility>

vtkStandardNewMacro(vtkScanRemeshFilter);

std::vector<scan::Phase> vtkScanRemeshFilter::Phases() const
{
  return { { "remesh", 60.0 }, { "check", 5.0 } };
}

scan::SurfaceEdit vtkScanRemeshFilter::Edit(const Surface& surface, scan::Execution& execution)
{
  scan::RemeshOptions options = this->Options;
  options.edgeLength = InModelUnits(this->EdgeLength, surface);
  options.maxDeviation = surface.maxDeviation;
  const std::vector<std::uint8_t> inRegion = this->TrianglesInRegion(surface, execution);
  this->Result = scan::remesh(surface.mesh, inRegion, options, execution);
  if (this->Result.heldBack > 0)
  {
    this->AddNote(std::to_string(this->Result.heldBack) +
      " triangles stay as they are, where new ones would cut the surface or leave the limit, or "
      "the surface is damaged");
  }
  return std::exchange(this->Result.edit, {});
}
