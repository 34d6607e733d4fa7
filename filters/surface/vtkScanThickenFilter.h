// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/thicken.h"
#include "filters/surface/vtkScanSurfaceFilter.h"

/// Turns a surface into a solid of uniform thickness; see scan::thicken. Both copies of a point
/// have its data and its ScanPointId. The region "folded" of
/// the output is where the solid folds onto itself; a note warns of it.
class SCANFILTERS_EXPORT vtkScanThickenFilter : public vtkScanSurfaceFilter
{
public:
  static vtkScanThickenFilter* New();
  vtkTypeMacro(vtkScanThickenFilter, vtkScanSurfaceFilter);
  vtkScanThickenFilter(const vtkScanThickenFilter&) = delete;
  void operator=(const vtkScanThickenFilter&) = delete;

  /// More than 0. Default: twice the mean spacing.
  void SetThickness(const scan::Length& thickness)
  {
    this->Thickness = thickness;
    this->Modified();
  }

  /// Default: both.
  void SetSide(scan::ThickenSide side)
  {
    this->Options.side = side;
    this->Modified();
  }

  /// Of the last run, without the surface.
  const scan::ThickenResult& GetResult() const { return this->Result; }

  /// Of the last run, in model units.
  double GetThickness() const { return this->Options.thickness; }

protected:
  vtkScanThickenFilter() = default;
  ~vtkScanThickenFilter() override = default;

  std::vector<scan::Phase> Phases() const override;
  scan::SurfaceEdit Edit(const Surface& surface, scan::Execution& execution) override;
  void Finish(vtkPolyData& output) override;

private:
  scan::Length Thickness = scan::Length(2.0, scan::Length::Unit::spacing);
  scan::ThickenOptions Options;
  scan::ThickenResult Result;
};
