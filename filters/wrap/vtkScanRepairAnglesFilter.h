// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/angle_repair.h"
#include "filters/wrap/vtkScanWrapEditFilter.h"

/// Repairs bites along feature lines, at the marks or everywhere. See scan::repairAngles.
class SCANFILTERS_EXPORT vtkScanRepairAnglesFilter : public vtkScanWrapEditFilter
{
public:
  static vtkScanRepairAnglesFilter* New();
  vtkTypeMacro(vtkScanRepairAnglesFilter, vtkScanWrapEditFilter);
  vtkScanRepairAnglesFilter(const vtkScanRepairAnglesFilter&) = delete;
  void operator=(const vtkScanRepairAnglesFilter&) = delete;

  /// Degrees by which an edge turns at least to be a feature. Default: 30.
  vtkSetClampMacro(FeatureAngle, double, 0.0, 180.0);
  vtkGetMacro(FeatureAngle, double);

  /// Of the last run.
  const scan::AngleRepairReport& GetRepairReport() const { return this->Repairs; }

protected:
  vtkScanRepairAnglesFilter() = default;
  ~vtkScanRepairAnglesFilter() override = default;

  void Edit(vtkScanWrapData& wrap, scan::WrapModel& model, vtkScanWrapEditReport& report,
    scan::Execution& execution) override;

private:
  double FeatureAngle = 30.0;
  scan::AngleRepairReport Repairs;
};
