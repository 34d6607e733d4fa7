// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/fill_holes.h"
#include "filters/surface/vtkScanSurfaceFilter.h"

#include <string>

/// Closes holes of a surface. See scan::fillHoles. A region means the holes all of whose rim is
/// inside; the largest deviation is that from flat patches.
class SCANFILTERS_EXPORT vtkScanFillHolesFilter : public vtkScanSurfaceFilter
{
public:
  static vtkScanFillHolesFilter* New();
  vtkTypeMacro(vtkScanFillHolesFilter, vtkScanSurfaceFilter);
  vtkScanFillHolesFilter(const vtkScanFillHolesFilter&) = delete;
  void operator=(const vtkScanFillHolesFilter&) = delete;

  /// How patches continue the surface. Default: tangent.
  void SetShape(scan::FillShape shape)
  {
    this->Options.shape = shape;
    this->Modified();
  }

  /// What bounds an open surface, and so is no hole. Default: automatic.
  void SetOuterRims(scan::OuterRims rims)
  {
    this->Options.outerRims = rims;
    this->Modified();
  }

  /// Holes with a longer rim are left. Default: 0, none.
  void SetMaxPerimeter(const scan::Length& maxPerimeter)
  {
    this->MaxPerimeter = maxPerimeter;
    this->Modified();
  }

  /// Holes with more edges are left. Default: 0, none.
  void SetMaxEdges(scan::Index maxEdges)
  {
    this->Options.maxEdges = maxEdges;
    this->Modified();
  }

  /// Fills only the holes nearest to such places. Default: none, all holes.
  void AddPlace(double x, double y, double z)
  {
    this->Options.at.push_back({ x, y, z });
    this->Modified();
  }

  /// Fills only the part of a hole between the two places of its rim nearest to these.
  void SetPart(const scan::RimPart& part)
  {
    this->Options.part = part;
    this->Modified();
  }

  /// Of the last run, without the surface.
  const scan::FillHolesResult& GetResult() const { return this->Result; }

protected:
  vtkScanFillHolesFilter() = default;
  ~vtkScanFillHolesFilter() override = default;

  std::vector<scan::Phase> Phases() const override;
  scan::SurfaceEdit Edit(const Surface& surface, scan::Execution& execution) override;

private:
  std::string Left() const;

  scan::Length MaxPerimeter;
  scan::FillHolesOptions Options;
  scan::FillHolesResult Result;
};
