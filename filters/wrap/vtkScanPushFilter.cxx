// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/wrap/vtkScanPushFilter.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkScanPushFilter);

void vtkScanPushFilter::Edit(vtkScanWrapData& wrap, scan::WrapModel& model,
  vtkScanWrapEditReport& report, scan::Execution& execution)
{
  const std::vector<scan::Facet> marks = this->FindMarks(wrap, execution);
  const std::vector<scan::BlockName> named = this->FindBlocks(model.scan->blocks(execution));
  this->SetPushReport(
    marks.size() + named.size(), push(model, marks, named, this->GetOptions(), execution), report);
}
