// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/sharpen.h"
#include "filters/surface/vtkScanSurfaceFilter.h"

/// Makes edges sharp that sampling has cut off; see scan::sharpen.
class SCANFILTERS_EXPORT vtkScanSharpenFilter : public vtkScanSurfaceFilter
{
public:
  static vtkScanSharpenFilter* New();
  vtkTypeMacro(vtkScanSharpenFilter, vtkScanSurfaceFilter);
  vtkScanSharpenFilter(const vtkScanSharpenFilter&) = delete;
  void operator=(const vtkScanSharpenFilter&) = delete;

  /// Degrees, more than 0, less than 90: triangles that turn by more are not smooth. Default: 20.
  void SetAngle(double angle)
  {
    this->Options.angle = angle;
    this->Modified();
  }

  /// Of the last run, without the surface.
  const scan::SharpenResult& GetResult() const { return this->Result; }

protected:
  vtkScanSharpenFilter() = default;
  ~vtkScanSharpenFilter() override = default;

  std::vector<scan::Phase> Phases() const override;
  scan::SurfaceEdit Edit(const Surface& surface, scan::Execution& execution) override;

private:
  scan::SharpenOptions Options;
  scan::SharpenResult Result;
};
