// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/surface/vtkScanOffsetFilter.h"

#include "filters/surface/folded_region.h"

#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include <utility>

vtkStandardNewMacro(vtkScanOffsetFilter);

std::vector<scan::Phase> vtkScanOffsetFilter::Phases() const
{
  return { { "offset", 1.0 }, { "folds", 2.0 } };
}

scan::SurfaceEdit vtkScanOffsetFilter::Edit(const Surface& surface, scan::Execution& execution)
{
  this->Options.distance = InModelUnits(this->Distance, surface);
  this->Options.maxDeviation = surface.maxDeviation;
  this->Result =
    scan::offset(surface.mesh, this->PointsInRegion(surface, execution), this->Options, execution);
  this->AddNote(scan::describe(this->Result.folds));
  return std::exchange(this->Result.edit, {});
}

void vtkScanOffsetFilter::Finish(vtkPolyData& output)
{
  scan::markFolds(this->Result.folds, output);
}
