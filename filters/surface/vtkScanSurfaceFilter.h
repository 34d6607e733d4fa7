// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/length.h"
#include "filters/base/vtkScanPolyDataFilter.h"
#include "filters/geometry/surface_deviation.h"
#include "filters/geometry/surface_edit.h"

#include <optional>
#include <vector>

/// Base of the operations that change a surface. A subclass turns the triangles of the input into
/// others and says where the parts come from; data, scan-point ids and the report on how far the
/// surface moved are taken care of here, see scan::setSurface().
class SCANFILTERS_EXPORT vtkScanSurfaceFilter : public vtkScanPolyDataFilter
{
public:
  vtkTypeMacro(vtkScanSurfaceFilter, vtkScanPolyDataFilter);
  vtkScanSurfaceFilter(const vtkScanSurfaceFilter&) = delete;
  void operator=(const vtkScanSurfaceFilter&) = delete;

  /// The surface stays within this distance of where it was: the operation stops or holds back
  /// there. Default: 0, no limit.
  void SetMaxDeviation(const scan::Length& maxDeviation)
  {
    this->MaxDeviation = maxDeviation;
    this->Modified();
  }

  const scan::Length& GetMaxDeviation() const { return this->MaxDeviation; }

  /// Whether to measure how far the surface moves. Default: true.
  void SetMeasure(bool measure)
  {
    this->Measure = measure;
    this->Modified();
  }

  /// Both ways: the means are those of both together, the place is that of the largest.
  /// None when it was not measured in the last run, or one of the two has no triangles.
  const std::optional<scan::SurfaceDeviation>& GetDeviation() const { return this->Deviation; }

  vtkIdType GetTrianglesBefore() const { return this->TrianglesBefore; }
  vtkIdType GetTrianglesAfter() const { return this->TrianglesAfter; }

protected:
  vtkScanSurfaceFilter() = default;
  ~vtkScanSurfaceFilter() override = default;

  /// What an operation works on.
  struct Surface
  {
    const scan::TriMesh& mesh;
    const std::vector<vtkIdType>& cells; ///< of the triangles, see scan::bridge::meshOf()
    vtkPolyData& data;
    double maxDeviation; ///< in model units; infinity: no limit
  };

  /// As of the superclass, at once where there is no region.
  std::vector<std::uint8_t> PointsInRegion(
    const Surface& surface, scan::Execution& execution) const;
  std::vector<std::uint8_t> TrianglesInRegion(
    const Surface& surface, scan::Execution& execution) const;

  /// The phases that Edit() reports, with weights of about seconds for a million triangles.
  virtual std::vector<scan::Phase> Phases() const = 0;

  /// Throws scan::Error.
  virtual scan::SurfaceEdit Edit(const Surface& surface, scan::Execution& execution) = 0;

  /// A length of a property in model units.
  static double InModelUnits(const scan::Length& length, const Surface& surface);

  /// Called with the finished output, which has the regions of the input: for arrays or regions of
  /// an operation's own.
  virtual void Finish(vtkPolyData& output);

  void Run(vtkPolyData& input, vtkPolyData& output, scan::Execution& execution) final;

private:
  scan::Length MaxDeviation;
  bool Measure = true;
  std::optional<scan::SurfaceDeviation> Deviation;
  vtkIdType TrianglesBefore = 0;
  vtkIdType TrianglesAfter = 0;
};
