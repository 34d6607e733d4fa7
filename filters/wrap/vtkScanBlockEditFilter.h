// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/pushes.h"
#include "filters/wrap/vtkScanWrapEditFilter.h"

#include <cstdint>
#include <vector>

/// What pushing and pulling share: they work on whole blocks, shallow or deep, and may be given
/// blocks by their numbers beside the marks.
class SCANFILTERS_EXPORT vtkScanBlockEditFilter : public vtkScanWrapEditFilter
{
public:
  vtkTypeMacro(vtkScanBlockEditFilter, vtkScanWrapEditFilter);
  vtkScanBlockEditFilter(const vtkScanBlockEditFilter&) = delete;
  void operator=(const vtkScanBlockEditFilter&) = delete;

  /// And every block that one can pass to, recursively. Default: false.
  vtkSetMacro(Deep, bool);
  vtkGetMacro(Deep, bool);
  vtkBooleanMacro(Deep, bool);

  /// One passes from a block of size r through doors of at least r / Reach. Default 1.5, at
  /// least 1.
  vtkSetClampMacro(Reach, double, 1.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Reach, double);

  /// Gives a block by its number, as the array Block has it.
  void AddBlock(std::int64_t number)
  {
    this->Numbers.push_back(number);
    this->Modified();
  }

  /// What the last run did; of a preview what it would do. Blocks in the order they were reached.
  const scan::PushReport& GetPushReport() const { return this->Pushed; }

protected:
  vtkScanBlockEditFilter() = default;
  ~vtkScanBlockEditFilter() override = default;

  scan::PushOptions GetOptions() const { return { .deep = this->Deep, .reach = this->Reach }; }

  /// @throws scan::Error for a number that no block has
  std::vector<scan::BlockName> FindBlocks(const scan::Blocks& blocks) const;

  void SetPushReport(std::size_t marks, scan::PushReport pushed, vtkScanWrapEditReport& report);

private:
  bool Deep = false;
  double Reach = 1.5;
  std::vector<std::int64_t> Numbers;
  scan::PushReport Pushed;
};
