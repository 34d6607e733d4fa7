// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/wrap/vtkScanRemoveWebsFilter.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkScanRemoveWebsFilter);

void vtkScanRemoveWebsFilter::Edit(vtkScanWrapData& wrap, scan::WrapModel& model,
  vtkScanWrapEditReport& report, scan::Execution& execution)
{
  const std::vector<scan::Facet> region = this->FindMarks(wrap, execution);
  report.Marks = static_cast<scan::Index>(region.size());
  if (this->IsNowhere(region))
  {
    return;
  }
  this->Webs = removeWebs(model, region, { .factor = this->Factor }, execution);
  report.Edit = this->Webs;
}
