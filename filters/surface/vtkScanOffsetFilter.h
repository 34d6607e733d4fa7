// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/offset.h"
#include "filters/surface/vtkScanSurfaceFilter.h"

/// Moves the surface along its normals; see scan::offset. The region "folded" of the output is
/// where it folds onto itself; a note warns of it.
class SCANFILTERS_EXPORT vtkScanOffsetFilter : public vtkScanSurfaceFilter
{
public:
  static vtkScanOffsetFilter* New();
  vtkTypeMacro(vtkScanOffsetFilter, vtkScanSurfaceFilter);
  vtkScanOffsetFilter(const vtkScanOffsetFilter&) = delete;
  void operator=(const vtkScanOffsetFilter&) = delete;

  /// Outwards, or inwards where it is negative. Default: the mean spacing.
  void SetDistance(const scan::Length& distance)
  {
    this->Distance = distance;
    this->Modified();
  }

  /// Of the last run, without the surface.
  const scan::OffsetResult& GetResult() const { return this->Result; }

  /// Of the last run, in model units.
  double GetDistance() const { return this->Options.distance; }

protected:
  vtkScanOffsetFilter() = default;
  ~vtkScanOffsetFilter() override = default;

  std::vector<scan::Phase> Phases() const override;
  scan::SurfaceEdit Edit(const Surface& surface, scan::Execution& execution) override;
  void Finish(vtkPolyData& output) override;

private:
  scan::Length Distance = scan::Length(1.0, scan::Length::Unit::spacing);
  scan::OffsetOptions Options;
  scan::OffsetResult Result;
};
