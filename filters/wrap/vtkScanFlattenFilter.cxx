// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/wrap/vtkScanFlattenFilter.h"

#include "filters/geometry/flatten.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkScanFlattenFilter);

void vtkScanFlattenFilter::Edit(vtkScanWrapData& wrap, scan::WrapModel& model,
  vtkScanWrapEditReport& report, scan::Execution& execution)
{
  const std::vector<scan::Facet> region = this->FindMarks(wrap, execution);
  report.Marks = static_cast<scan::Index>(region.size());
  if (this->IsNowhere(region))
  {
    return;
  }
  const scan::FlattenReport flattened = flatten(model, region, execution);
  this->Parts = flattened.parts;
  report.Edit = flattened;
}
