// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/block_marks.h"
#include "filters/wrap/vtkScanWrapEditFilter.h"

#include <cstdint>
#include <vector>

/// Pulls the surface out again: adds removed blocks back. A point marks the removed block around
/// it, else the nearest removed sheet; a triangle the removed block in front of it. See scan::pull.
class SCANFILTERS_EXPORT vtkScanPullFilter : public vtkScanWrapEditFilter
{
public:
  static vtkScanPullFilter* New();
  vtkTypeMacro(vtkScanPullFilter, vtkScanWrapEditFilter);
  vtkScanPullFilter(const vtkScanPullFilter&) = delete;
  void operator=(const vtkScanPullFilter&) = delete;

  /// And every removed block that one can pass to, recursively. Default: false.
  vtkSetMacro(Deep, bool);
  vtkGetMacro(Deep, bool);
  vtkBooleanMacro(Deep, bool);

  /// One passes from a block of size r through doors of at least r / Reach. Default 1.5, at
  /// least 1.
  vtkSetClampMacro(Reach, double, 1.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Reach, double);

  /// Marks a block by its number, as the array Block has it.
  void AddBlock(std::int64_t number);

  /// The blocks that came back, or would, in the order they were reached.
  const std::vector<scan::BlockName>& GetBlocks() const { return this->Blocks; }

protected:
  vtkScanPullFilter() = default;
  ~vtkScanPullFilter() override = default;

  void Edit(vtkScanWrapData& wrap, scan::WrapModel& model, vtkScanWrapEditReport& report,
    scan::Execution& execution) override;

private:
  bool Deep = false;
  double Reach = 1.5;
  std::vector<std::int64_t> Numbers;
  std::vector<scan::BlockName> Blocks;
};
