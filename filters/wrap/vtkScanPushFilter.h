// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/wrap/vtkScanBlockEditFilter.h"

/// Pushes the surface in: removes the blocks behind the marks, and those given by number, shallow
/// or deep. See scan::push for the guarantees. Without a mark nothing happens.
class SCANFILTERS_EXPORT vtkScanPushFilter : public vtkScanBlockEditFilter
{
public:
  static vtkScanPushFilter* New();
  vtkTypeMacro(vtkScanPushFilter, vtkScanBlockEditFilter);
  vtkScanPushFilter(const vtkScanPushFilter&) = delete;
  void operator=(const vtkScanPushFilter&) = delete;

protected:
  vtkScanPushFilter() = default;
  ~vtkScanPushFilter() override = default;

  void Edit(vtkScanWrapData& wrap, scan::WrapModel& model, vtkScanWrapEditReport& report,
    scan::Execution& execution) override;
};
