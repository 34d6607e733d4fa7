// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/wrap/vtkScanRepairAnglesFilter.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkScanRepairAnglesFilter);

void vtkScanRepairAnglesFilter::Edit(vtkScanWrapData& wrap, scan::WrapModel& model,
  vtkScanWrapEditReport& report, scan::Execution& execution)
{
  const std::vector<scan::Facet> region = this->FindMarks(wrap, execution);
  report.Marks = static_cast<scan::Index>(region.size());
  if (this->IsNowhere(region))
  {
    return;
  }
  this->Repairs = repairAngles(model, region, { .featureAngle = this->FeatureAngle }, execution);
  report.Edit = this->Repairs;
}
