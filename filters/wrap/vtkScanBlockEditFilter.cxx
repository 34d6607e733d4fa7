// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/wrap/vtkScanBlockEditFilter.h"

std::vector<scan::BlockName> vtkScanBlockEditFilter::FindBlocks(const scan::Blocks& blocks) const
{
  std::vector<scan::BlockName> found;
  for (const std::int64_t number : this->Numbers)
  {
    found.push_back(blockOfNumber(blocks, number));
  }
  return found;
}

void vtkScanBlockEditFilter::SetPushReport(
  std::size_t marks, scan::PushReport pushed, vtkScanWrapEditReport& report)
{
  report.Marks = static_cast<scan::Index>(marks);
  report.Edit = pushed;
  this->Pushed = std::move(pushed);
}
