// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/surface/vtkScanOrientFilter.h"

#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include <string>
#include <utility>

vtkStandardNewMacro(vtkScanOrientFilter);

std::vector<scan::Phase> vtkScanOrientFilter::Phases() const
{
  return { { "orient", 1.0 } };
}

scan::SurfaceEdit vtkScanOrientFilter::Edit(const Surface& surface, scan::Execution& execution)
{
  const std::vector<std::uint8_t> inRegion = this->TrianglesInRegion(surface, execution);
  this->Result = scan::orientSurface(surface.mesh, inRegion, this->Options, execution);
  if (this->Result.disagreeingPieces > 0)
  {
    this->AddNote(std::to_string(this->Result.disagreeingPieces) +
      (this->Options.flip ? " pieces have neighbours that disagree"
                          : " pieces are one-sided and keep a seam; mend cuts them there"));
  }
  scan::SurfaceEdit edit = scan::unchanged(surface.mesh);
  edit.mesh.triangles = std::exchange(this->Result.triangles, {});
  return edit;
}
