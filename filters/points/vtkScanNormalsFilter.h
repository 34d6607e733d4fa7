// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/vtkScanPolyDataFilter.h"
#include "filters/geometry/point_normals.h"

/// Gives the points of the region normals, array Normals; points elsewhere keep theirs, or have
/// (0, 0, 0). See scan::pointNormals.
class SCANFILTERS_EXPORT vtkScanNormalsFilter : public vtkScanPolyDataFilter
{
public:
  static vtkScanNormalsFilter* New();
  vtkTypeMacro(vtkScanNormalsFilter, vtkScanPolyDataFilter);
  vtkScanNormalsFilter(const vtkScanNormalsFilter&) = delete;
  void operator=(const vtkScanNormalsFilter&) = delete;

  /// Points that suggest a plane, 3 to 1000. Default: 16.
  void SetNeighbours(scan::Index neighbours)
  {
    this->Options.neighbours = neighbours;
    this->Modified();
  }

  /// Default: scan::PointNormalOptions::Orient::outward.
  void SetOrient(scan::PointNormalOptions::Orient orient)
  {
    this->Options.orient = orient;
    this->Modified();
  }

  /// Where the scanner stood, for Orient::toward. Default: the origin.
  void SetViewpoint(double x, double y, double z)
  {
    this->Options.viewpoint = { x, y, z };
    this->Modified();
  }

  /// Of the last run, without the normals.
  const scan::PointNormalResult& GetResult() const { return this->Result; }

protected:
  vtkScanNormalsFilter() = default;
  ~vtkScanNormalsFilter() override = default;

  void Run(vtkPolyData& input, vtkPolyData& output, scan::Execution& execution) override;

private:
  scan::PointNormalOptions Options;
  scan::PointNormalResult Result;
};
