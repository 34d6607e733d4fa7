// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/surface/vtkScanThickenFilter.h"

#include "filters/surface/folded_region.h"

#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include <utility>

vtkStandardNewMacro(vtkScanThickenFilter);

std::vector<scan::Phase> vtkScanThickenFilter::Phases() const
{
  return { { "thicken", 1.0 }, { "folds", 4.0 } };
}

scan::SurfaceEdit vtkScanThickenFilter::Edit(const Surface& surface, scan::Execution& execution)
{
  this->Options.thickness = InModelUnits(this->Thickness, surface);
  this->Options.maxDeviation = surface.maxDeviation;
  this->Result = scan::thicken(
    surface.mesh, this->TrianglesInRegion(surface, execution), this->Options, execution);
  this->AddNote(scan::describe(this->Result.changes));
  this->AddNote(scan::describe(this->Result.folds));
  return std::exchange(this->Result.edit, {});
}

void vtkScanThickenFilter::Finish(vtkPolyData& output)
{
  scan::markFolds(this->Result.folds, output);
}
