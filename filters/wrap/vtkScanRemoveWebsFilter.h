// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/webs.h"
#include "filters/wrap/vtkScanWrapEditFilter.h"

/// Removes sheets that span what was not scanned, at the marks or everywhere. See scan::removeWebs.
class SCANFILTERS_EXPORT vtkScanRemoveWebsFilter : public vtkScanWrapEditFilter
{
public:
  static vtkScanRemoveWebsFilter* New();
  vtkTypeMacro(vtkScanRemoveWebsFilter, vtkScanWrapEditFilter);
  vtkScanRemoveWebsFilter(const vtkScanRemoveWebsFilter&) = delete;
  void operator=(const vtkScanRemoveWebsFilter&) = delete;

  /// A sheet triangle is sparse when its circumradius exceeds so many local spacings. Default: 4.
  vtkSetClampMacro(Factor, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Factor, double);

  /// Of the last run.
  const scan::WebReport& GetWebReport() const { return this->Webs; }

protected:
  vtkScanRemoveWebsFilter() = default;
  ~vtkScanRemoveWebsFilter() override = default;

  void Edit(vtkScanWrapData& wrap, scan::WrapModel& model, vtkScanWrapEditReport& report,
    scan::Execution& execution) override;

private:
  double Factor = 4.0;
  scan::WebReport Webs;
};
