// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ScanFiltersModule.h" // export macro
#include "filters/base/vtkScanPolyDataFilter.h"

/// Keeps what is in the region, or erases it: of a surface triangles and the points that they use,
/// of a scan points, with their data. The region is needed. A surface becomes plain vtkPolyData of
/// triangles. See scan::bridge::keepRegion().
class SCANFILTERS_EXPORT vtkScanCropFilter : public vtkScanPolyDataFilter
{
public:
  static vtkScanCropFilter* New();
  vtkTypeMacro(vtkScanCropFilter, vtkScanPolyDataFilter);
  vtkScanCropFilter(const vtkScanCropFilter&) = delete;
  void operator=(const vtkScanCropFilter&) = delete;

  /// Keep what is outside instead. Default: false.
  vtkSetMacro(Erase, bool);
  vtkGetMacro(Erase, bool);
  vtkBooleanMacro(Erase, bool);

  ///@{
  /// What the last run took away.
  vtkIdType GetPointsGone() const { return this->PointsGone; }
  vtkIdType GetTrianglesGone() const { return this->TrianglesGone; }
  ///@}

protected:
  vtkScanCropFilter() = default;
  ~vtkScanCropFilter() override = default;

  void Run(vtkPolyData& input, vtkPolyData& output, scan::Execution& execution) override;

private:
  bool Erase = false;
  vtkIdType PointsGone = 0;
  vtkIdType TrianglesGone = 0;
};
