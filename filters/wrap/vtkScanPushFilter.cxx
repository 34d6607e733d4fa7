// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/wrap/vtkScanPushFilter.h"

#include "filters/geometry/pushes.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkScanPushFilter);

void vtkScanPushFilter::AddBlock(std::int64_t number)
{
  this->Numbers.push_back(number);
  this->Modified();
}

void vtkScanPushFilter::Edit(vtkScanWrapData& wrap, scan::WrapModel& model,
  vtkScanWrapEditReport& report, scan::Execution& execution)
{
  const std::vector<scan::Facet> marks = this->FindMarks(wrap, execution);
  report.Marks = static_cast<scan::Index>(marks.size() + this->Numbers.size());
  const scan::PushOptions options{ .deep = this->Deep, .reach = this->Reach };
  std::vector<scan::BlockName> named;
  for (const std::int64_t number : this->Numbers)
  {
    named.push_back(blockOfNumber(model.scan->blocks(execution), number));
  }
  const scan::PushReport pushed = push(model, marks, named, options, execution);
  this->Blocks = pushed.blocks;
  this->Doors = pushed.doors;
  report.Edit = pushed;
}
