// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/wrap/vtkScanPullFilter.h"

#include "filters/geometry/pushes.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkScanPullFilter);

void vtkScanPullFilter::AddBlock(std::int64_t number)
{
  this->Numbers.push_back(number);
  this->Modified();
}

void vtkScanPullFilter::Edit(vtkScanWrapData& wrap, scan::WrapModel& model,
  vtkScanWrapEditReport& report, scan::Execution& execution)
{
  const scan::Blocks& blocks = model.scan->blocks(execution);
  std::vector<scan::BlockName> removed;
  for (const std::int64_t number : this->Numbers)
  {
    removed.push_back(blockOfNumber(blocks, number));
  }
  for (const scan::Vec3& point : this->GetPoints())
  {
    removed.push_back(removedBlockAt(model, point, execution));
  }
  for (const scan::Facet facet : this->FindTriangles(wrap))
  {
    removed.push_back(removedBlockBefore(model, blocks, facet));
  }
  report.Marks = static_cast<scan::Index>(removed.size());
  const scan::PushOptions options{ .deep = this->Deep, .reach = this->Reach };
  const scan::PushReport pulled = pull(model, removed, options, execution);
  this->Blocks = pulled.blocks;
  report.Edit = pulled;
}
