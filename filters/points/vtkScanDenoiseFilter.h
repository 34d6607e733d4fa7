// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/length.h"
#include "filters/base/vtkScanPolyDataFilter.h"
#include "filters/geometry/denoise.h"

/// Moves the points of the region onto the surface that their neighbours suggest. See
/// scan::denoise. Cells and data stay; normals, too, as they differ less from those of the moved
/// points than the noise of both.
class SCANFILTERS_EXPORT vtkScanDenoiseFilter : public vtkScanPolyDataFilter
{
public:
  static vtkScanDenoiseFilter* New();
  vtkTypeMacro(vtkScanDenoiseFilter, vtkScanPolyDataFilter);
  vtkScanDenoiseFilter(const vtkScanDenoiseFilter&) = delete;
  void operator=(const vtkScanDenoiseFilter&) = delete;

  /// No point moves farther, all iterations together. Default: twice the mean spacing.
  void SetMaxShift(const scan::Length& maxShift)
  {
    this->MaxShift = maxShift;
    this->Modified();
  }

  /// 1 or more. Default: 3.
  void SetIterations(int iterations)
  {
    this->Options.iterations = iterations;
    this->Modified();
  }

  /// Points that a surface is fitted to, 8 to 1000. Default: 32.
  void SetNeighbours(scan::Index neighbours)
  {
    this->Options.neighbours = neighbours;
    this->Modified();
  }

  /// Of the last run, without the points.
  const scan::DenoiseResult& GetResult() const { return this->Result; }

  /// Of the last run, in model units.
  double GetLimit() const { return this->Limit; }

protected:
  vtkScanDenoiseFilter() = default;
  ~vtkScanDenoiseFilter() override = default;

  void Run(vtkPolyData& input, vtkPolyData& output, scan::Execution& execution) override;

private:
  scan::Length MaxShift = scan::Length(2.0, scan::Length::Unit::spacing);
  scan::DenoiseOptions Options;
  scan::DenoiseResult Result;
  double Limit = 0.0;
};
