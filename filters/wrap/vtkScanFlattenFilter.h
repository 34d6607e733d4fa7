// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/wrap/vtkScanWrapEditFilter.h"

/// Replaces thin parts by sheets, at the marks or everywhere. See scan::flatten.
class SCANFILTERS_EXPORT vtkScanFlattenFilter : public vtkScanWrapEditFilter
{
public:
  static vtkScanFlattenFilter* New();
  vtkTypeMacro(vtkScanFlattenFilter, vtkScanWrapEditFilter);
  vtkScanFlattenFilter(const vtkScanFlattenFilter&) = delete;
  void operator=(const vtkScanFlattenFilter&) = delete;

  /// Thin parts that became sheets in the last run.
  scan::Index GetParts() const { return this->Parts; }

protected:
  vtkScanFlattenFilter() = default;
  ~vtkScanFlattenFilter() override = default;

  void Edit(vtkScanWrapData& wrap, scan::WrapModel& model, vtkScanWrapEditReport& report,
    scan::Execution& execution) override;

private:
  scan::Index Parts = 0;
};
