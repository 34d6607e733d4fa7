// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/refine.h"
#include "filters/surface/vtkScanSurfaceFilter.h"

#include <cstdint>
#include <vector>

/// Cuts the triangles of the region into four, and their neighbours as it takes. See scan::refine.
/// The cell array scan::arrays::kHalf tells the next refinement which triangles are halves.
class SCANFILTERS_EXPORT vtkScanRefineFilter : public vtkScanSurfaceFilter
{
public:
  static vtkScanRefineFilter* New();
  vtkTypeMacro(vtkScanRefineFilter, vtkScanSurfaceFilter);
  vtkScanRefineFilter(const vtkScanRefineFilter&) = delete;
  void operator=(const vtkScanRefineFilter&) = delete;

  using Mode = scan::RefineOptions::Mode;

  /// Default: loop.
  void SetMode(Mode mode)
  {
    this->Options.mode = mode;
    this->Modified();
  }

  /// 1 to 8. Default: 1.
  void SetTimes(int times)
  {
    this->Options.times = times;
    this->Modified();
  }

  /// Degrees, 0 to 180. Default: 180, no creases.
  void SetCreaseAngle(double degrees)
  {
    this->Options.creaseAngle = degrees;
    this->Modified();
  }

  /// Of the last run, without the surface and the marks.
  const scan::RefineResult& GetResult() const { return this->Result; }

  vtkIdType GetPointsAdded() const { return this->PointsAdded; }

protected:
  vtkScanRefineFilter() = default;
  ~vtkScanRefineFilter() override = default;

  std::vector<scan::Phase> Phases() const override;
  scan::SurfaceEdit Edit(const Surface& surface, scan::Execution& execution) override;
  void Finish(vtkPolyData& output) override;

private:
  scan::RefineOptions Options;
  scan::RefineResult Result;
  vtkIdType PointsAdded = 0;
};
