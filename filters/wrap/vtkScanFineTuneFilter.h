// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/wrap/vtkScanWrapEditFilter.h"

/// Pushes or fills single tetrahedra at the marks. See scan::pushTets and scan::fillTets. Without a
/// mark nothing happens.
class SCANFILTERS_EXPORT vtkScanFineTuneFilter : public vtkScanWrapEditFilter
{
public:
  static vtkScanFineTuneFilter* New();
  vtkTypeMacro(vtkScanFineTuneFilter, vtkScanWrapEditFilter);
  vtkScanFineTuneFilter(const vtkScanFineTuneFilter&) = delete;
  void operator=(const vtkScanFineTuneFilter&) = delete;

  /// Fill the tetrahedron in front of each mark instead of removing the one behind it; at a sheet
  /// the one on the side of the point that marks it. Default: false.
  vtkSetMacro(Fill, bool);
  vtkGetMacro(Fill, bool);
  vtkBooleanMacro(Fill, bool);

protected:
  vtkScanFineTuneFilter() = default;
  ~vtkScanFineTuneFilter() override = default;

  void Edit(vtkScanWrapData& wrap, scan::WrapModel& model, vtkScanWrapEditReport& report,
    scan::Execution& execution) override;

private:
  bool Fill = false;
};
