// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/remesh.h"
#include "filters/surface/vtkScanSurfaceFilter.h"

/// Replaces the triangles of the region by nearly equilateral ones. See scan::remesh.
class SCANFILTERS_EXPORT vtkScanRemeshFilter : public vtkScanSurfaceFilter
{
public:
  static vtkScanRemeshFilter* New();
  vtkTypeMacro(vtkScanRemeshFilter, vtkScanSurfaceFilter);
  vtkScanRemeshFilter(const vtkScanRemeshFilter&) = delete;
  void operator=(const vtkScanRemeshFilter&) = delete;

  /// Default: 0, the mean of the region.
  void SetEdgeLength(const scan::Length& edgeLength)
  {
    this->EdgeLength = edgeLength;
    this->Modified();
  }

  /// 1 or more. Default: 5.
  void SetIterations(int iterations)
  {
    this->Options.iterations = iterations;
    this->Modified();
  }

  /// Degrees: where the surface bends more, edges stay. Default: 180, nowhere.
  void SetKeepFeatures(double degrees)
  {
    this->Options.keepFeatures = degrees;
    this->Modified();
  }

  /// Of the last run, without the surface.
  const scan::RemeshResult& GetResult() const { return this->Result; }

protected:
  vtkScanRemeshFilter() = default;
  ~vtkScanRemeshFilter() override = default;

  std::vector<scan::Phase> Phases() const override;
  scan::SurfaceEdit Edit(const Surface& surface, scan::Execution& execution) override;

private:
  scan::Length EdgeLength;
  scan::RemeshOptions Options;
  scan::RemeshResult Result;
};
