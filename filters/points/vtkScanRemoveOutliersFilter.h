// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/vtkScanPolyDataFilter.h"
#include "filters/geometry/outliers.h"

/// Removes stray points of the region, and the cells on them. See scan::findOutliers.
class SCANFILTERS_EXPORT vtkScanRemoveOutliersFilter : public vtkScanPolyDataFilter
{
public:
  static vtkScanRemoveOutliersFilter* New();
  vtkTypeMacro(vtkScanRemoveOutliersFilter, vtkScanPolyDataFilter);
  vtkScanRemoveOutliersFilter(const vtkScanRemoveOutliersFilter&) = delete;
  void operator=(const vtkScanRemoveOutliersFilter&) = delete;

  /// Points that a point is compared with, 4 to 1000. Default: 16.
  void SetNeighbours(scan::Index neighbours)
  {
    this->Options.neighbours = neighbours;
    this->Modified();
  }

  /// A stray point is so many times as far from its neighbours as is usual there. Default: 3.
  void SetFactor(double factor)
  {
    this->Options.factor = factor;
    this->Modified();
  }

  /// Of the last run.
  const scan::OutlierResult& GetResult() const { return this->Result; }

protected:
  vtkScanRemoveOutliersFilter() = default;
  ~vtkScanRemoveOutliersFilter() override = default;

  void Run(vtkPolyData& input, vtkPolyData& output, scan::Execution& execution) override;

private:
  scan::OutlierOptions Options;
  scan::OutlierResult Result;
};
