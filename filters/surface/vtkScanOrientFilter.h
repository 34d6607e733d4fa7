// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/orient_outward.h"
#include "filters/surface/vtkScanSurfaceFilter.h"

/// Turns triangles over. See scan::orientSurface. A region means pieces with a triangle in it; for
/// a flip the triangles in it.
class SCANFILTERS_EXPORT vtkScanOrientFilter : public vtkScanSurfaceFilter
{
public:
  static vtkScanOrientFilter* New();
  vtkTypeMacro(vtkScanOrientFilter, vtkScanSurfaceFilter);
  vtkScanOrientFilter(const vtkScanOrientFilter&) = delete;
  void operator=(const vtkScanOrientFilter&) = delete;

  /// Closed pieces shall face outwards. Default: true.
  void SetOutward(bool outward)
  {
    this->Options.outward = outward;
    this->Modified();
  }

  /// Instead turns over every triangle of the region. Default: false.
  void SetFlip(bool flip)
  {
    this->Options.flip = flip;
    this->Modified();
  }

  /// Of the last run, without the triangles.
  const scan::OrientResult& GetResult() const { return this->Result; }

protected:
  vtkScanOrientFilter() = default;
  ~vtkScanOrientFilter() override = default;

  std::vector<scan::Phase> Phases() const override;
  scan::SurfaceEdit Edit(const Surface& surface, scan::Execution& execution) override;

private:
  scan::OrientOptions Options;
  scan::OrientResult Result;
};
