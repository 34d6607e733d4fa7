// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/wrap/vtkScanBlockEditFilter.h"

/// Pulls the surface out again: adds removed blocks back. A point marks the removed block around
/// it, else the nearest removed sheet; a triangle the removed block in front of it. See scan::pull.
class SCANFILTERS_EXPORT vtkScanPullFilter : public vtkScanBlockEditFilter
{
public:
  static vtkScanPullFilter* New();
  vtkTypeMacro(vtkScanPullFilter, vtkScanBlockEditFilter);
  vtkScanPullFilter(const vtkScanPullFilter&) = delete;
  void operator=(const vtkScanPullFilter&) = delete;

protected:
  vtkScanPullFilter() = default;
  ~vtkScanPullFilter() override = default;

  void Edit(vtkScanWrapData& wrap, scan::WrapModel& model, vtkScanWrapEditReport& report,
    scan::Execution& execution) override;
};
