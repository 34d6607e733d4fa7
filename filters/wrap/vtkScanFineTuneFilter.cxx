// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/wrap/vtkScanFineTuneFilter.h"

#include "filters/geometry/single_tets.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkScanFineTuneFilter);

void vtkScanFineTuneFilter::Edit(vtkScanWrapData& wrap, scan::WrapModel& model,
  vtkScanWrapEditReport& report, scan::Execution& execution)
{
  const std::vector<scan::Facet> marks = this->FindMarks(wrap, execution);
  report.Marks = static_cast<scan::Index>(marks.size());
  report.Edit = this->Fill ? fillTets(model, marks, execution) : pushTets(model, marks, execution);
}
