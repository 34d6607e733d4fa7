// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/block_marks.h"
#include "filters/wrap/vtkScanWrapEditFilter.h"

/// Shoots through the model from each mark: pushes every block that the ray meets until it leaves
/// the model. See scan::blocksInSight.
class SCANFILTERS_EXPORT vtkScanShootFilter : public vtkScanWrapEditFilter
{
public:
  static vtkScanShootFilter* New();
  vtkTypeMacro(vtkScanShootFilter, vtkScanWrapEditFilter);
  vtkScanShootFilter(const vtkScanShootFilter&) = delete;
  void operator=(const vtkScanShootFilter&) = delete;

  /// The way the shots go; (0, 0, 0), the default, is straight in, against the triangle's normal.
  vtkSetVector3Macro(Direction, double);
  vtkGetVector3Macro(Direction, double);

  /// The blocks that went, or would go.
  const std::vector<scan::BlockName>& GetBlocks() const { return this->Blocks; }

protected:
  vtkScanShootFilter() = default;
  ~vtkScanShootFilter() override = default;

  void Edit(vtkScanWrapData& wrap, scan::WrapModel& model, vtkScanWrapEditReport& report,
    scan::Execution& execution) override;

private:
  double Direction[3] = { 0.0, 0.0, 0.0 };
  std::vector<scan::BlockName> Blocks;
};
