// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/block_marks.h"
#include "filters/wrap/vtkScanWrapEditFilter.h"

#include <cstdint>
#include <vector>

/// Pushes the surface in at its marks: removes the blocks behind them, shallow or deep. See
/// scan::push for the guarantees. Without a mark nothing happens.
class SCANFILTERS_EXPORT vtkScanPushFilter : public vtkScanWrapEditFilter
{
public:
  static vtkScanPushFilter* New();
  vtkTypeMacro(vtkScanPushFilter, vtkScanWrapEditFilter);
  vtkScanPushFilter(const vtkScanPushFilter&) = delete;
  void operator=(const vtkScanPushFilter&) = delete;

  /// And every block that one can pass to, recursively. Default: false.
  vtkSetMacro(Deep, bool);
  vtkGetMacro(Deep, bool);
  vtkBooleanMacro(Deep, bool);

  /// One passes from a block of size r through doors of at least r / Reach. Default 1.5, at
  /// least 1.
  vtkSetClampMacro(Reach, double, 1.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Reach, double);

  /// Marks a block by its number, as the array Block has it.
  void AddBlock(std::int64_t number);

  /// The blocks that went, or would go, in the order they were reached.
  const std::vector<scan::BlockName>& GetBlocks() const { return this->Blocks; }
  scan::Index GetDoors() const { return this->Doors; }

protected:
  vtkScanPushFilter() = default;
  ~vtkScanPushFilter() override = default;

  void Edit(vtkScanWrapData& wrap, scan::WrapModel& model, vtkScanWrapEditReport& report,
    scan::Execution& execution) override;

private:
  bool Deep = false;
  double Reach = 1.5;
  std::vector<std::int64_t> Numbers;
  std::vector<scan::BlockName> Blocks;
  scan::Index Doors = 0;
};
