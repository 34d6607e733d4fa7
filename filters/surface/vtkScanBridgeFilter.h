// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/bridge.h"
#include "filters/surface/vtkScanSurfaceFilter.h"

/// Joins two rims of a surface, or two places of one, by a strip of triangles. See scan::bridge.
class SCANFILTERS_EXPORT vtkScanBridgeFilter : public vtkScanSurfaceFilter
{
public:
  static vtkScanBridgeFilter* New();
  vtkTypeMacro(vtkScanBridgeFilter, vtkScanSurfaceFilter);
  vtkScanBridgeFilter(const vtkScanBridgeFilter&) = delete;
  void operator=(const vtkScanBridgeFilter&) = delete;

  /// Where the bridge begins and ends: at the rims nearest to these places. Both must be set.
  void SetFrom(double x, double y, double z)
  {
    this->Options.from = { x, y, z };
    this->HasFrom = true;
    this->Modified();
  }
  void SetTo(double x, double y, double z)
  {
    this->Options.to = { x, y, z };
    this->HasTo = true;
    this->Modified();
  }

  /// Edges of each rim that are joined, 1 or more. Default: 1.
  void SetWidth(scan::Index width)
  {
    this->Options.width = width;
    this->Modified();
  }

  /// Of the last run, without the surface.
  const scan::BridgeResult& GetResult() const { return this->Result; }

protected:
  vtkScanBridgeFilter() = default;
  ~vtkScanBridgeFilter() override = default;

  std::vector<scan::Phase> Phases() const override;
  scan::SurfaceEdit Edit(const Surface& surface, scan::Execution& execution) override;

private:
  scan::BridgeOptions Options;
  bool HasFrom = false;
  bool HasTo = false;
  scan::BridgeResult Result;
};
