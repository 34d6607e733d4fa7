// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/vtkScanPolyDataFilter.h"
#include "filters/geometry/mesh.h"

#include <optional>
#include <vector>

/// Adds points behind those of the input, with scan-point ids behind the largest there is. Where
/// the input has colours or normals theirs are white and (0, 0, 0); other data is 0. The points of
/// a scan get a vertex each, and so do the new ones; of a mesh they are points that no triangle
/// uses.
class SCANFILTERS_EXPORT vtkScanAddPointsFilter : public vtkScanPolyDataFilter
{
public:
  static vtkScanAddPointsFilter* New();
  vtkTypeMacro(vtkScanAddPointsFilter, vtkScanPolyDataFilter);
  vtkScanAddPointsFilter(const vtkScanAddPointsFilter&) = delete;
  void operator=(const vtkScanAddPointsFilter&) = delete;

  void AddPoint(double x, double y, double z)
  {
    this->Points.push_back({ x, y, z });
    this->Modified();
  }

  enum AxisType
  {
    X,
    Y,
    Z
  };

  /// Moves the new points along an axis, as far as this place.
  void SetDepth(AxisType axis, double place)
  {
    this->Axis = axis;
    this->Depth = place;
    this->Modified();
  }

  ///@{
  /// Of the last run: points of the model.
  vtkIdType GetPointsBefore() const { return this->PointsBefore; }
  vtkIdType GetPointsAfter() const { return this->PointsAfter; }
  ///@}

protected:
  vtkScanAddPointsFilter() = default;
  ~vtkScanAddPointsFilter() override = default;

  void Run(vtkPolyData& input, vtkPolyData& output, scan::Execution& execution) override;

private:
  std::vector<scan::Vec3> Points;
  AxisType Axis = Y;
  std::optional<double> Depth;
  vtkIdType PointsBefore = 0;
  vtkIdType PointsAfter = 0;
};
