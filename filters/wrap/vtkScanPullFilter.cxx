// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/wrap/vtkScanPullFilter.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkScanPullFilter);

void vtkScanPullFilter::Edit(vtkScanWrapData& wrap, scan::WrapModel& model,
  vtkScanWrapEditReport& report, scan::Execution& execution)
{
  const scan::Blocks& blocks = model.scan->blocks(execution);
  std::vector<scan::BlockName> removed = this->FindBlocks(blocks);
  for (const scan::Vec3& point : this->GetPoints())
  {
    removed.push_back(removedBlockAt(model, point, execution));
  }
  for (const scan::Facet facet : this->FindTriangles(wrap, execution))
  {
    removed.push_back(removedBlockBefore(model, blocks, facet));
  }
  this->SetPushReport(removed.size(), pull(model, removed, this->GetOptions(), execution), report);
}
