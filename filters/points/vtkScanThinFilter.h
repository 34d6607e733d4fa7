// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/length.h"
#include "filters/base/vtkScanPolyDataFilter.h"
#include "filters/geometry/thin.h"

/// Keeps some of the points of the region, with their data, and the cells that lose none. See
/// scan::thin.
class SCANFILTERS_EXPORT vtkScanThinFilter : public vtkScanPolyDataFilter
{
public:
  static vtkScanThinFilter* New();
  vtkTypeMacro(vtkScanThinFilter, vtkScanPolyDataFilter);
  vtkScanThinFilter(const vtkScanThinFilter&) = delete;
  void operator=(const vtkScanThinFilter&) = delete;

  /// Default: scan::ThinOptions::By::spacing.
  void SetBy(scan::ThinOptions::By by)
  {
    this->Options.by = by;
    this->Modified();
  }

  /// Of random and curvature: percent of the points of the region, 0 to 100. Default: 25.
  void SetKeep(double percent)
  {
    this->Options.keep = percent;
    this->Modified();
  }

  /// Of spacing and grid. Default: twice the mean spacing.
  void SetSpacing(const scan::Length& spacing)
  {
    this->Spacing = spacing;
    this->Modified();
  }

  /// Of random and curvature. Default: 1.
  void SetSeed(std::uint64_t seed)
  {
    this->Options.seed = seed;
    this->Modified();
  }

  ///@{
  /// Of the last run: points of the model.
  vtkIdType GetPointsBefore() const { return this->PointsBefore; }
  vtkIdType GetPointsAfter() const { return this->PointsAfter; }
  ///@}

protected:
  vtkScanThinFilter() = default;
  ~vtkScanThinFilter() override = default;

  void Run(vtkPolyData& input, vtkPolyData& output, scan::Execution& execution) override;

private:
  scan::ThinOptions Options;
  scan::Length Spacing = scan::Length(2.0, scan::Length::Unit::spacing);
  vtkIdType PointsBefore = 0;
  vtkIdType PointsAfter = 0;
};
