// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/openmesh_decimate.h"
#include "filters/surface/vtkScanSurfaceFilter.h"

/// Reduces the triangles of a surface; see scan::decimate() and scan::decimateByOpenMesh(). With
/// neither a share nor a number nor a largest deviation, to half of them.
class SCANFILTERS_EXPORT vtkScanDecimateFilter : public vtkScanSurfaceFilter
{
public:
  static vtkScanDecimateFilter* New();
  vtkTypeMacro(vtkScanDecimateFilter, vtkScanSurfaceFilter);
  vtkScanDecimateFilter(const vtkScanDecimateFilter&) = delete;
  void operator=(const vtkScanDecimateFilter&) = delete;

  /// The share of the triangles to leave, of those in the region, 0 to 1. Default: 0, not given.
  void SetRatio(double ratio)
  {
    this->Ratio = ratio;
    this->Modified();
  }

  /// How many triangles to leave in the region. Default: 0, not given.
  void SetTriangles(vtkIdType triangles)
  {
    this->Triangles = triangles;
    this->Modified();
  }

  /// Degrees, 0 to 180. Default: 90.
  void SetCreaseAngle(double degrees)
  {
    this->Options.creaseAngle = degrees;
    this->Modified();
  }

  enum class Method
  {
    quadric,
    openmesh
  };

  /// Default: quadric.
  void SetMethod(Method method)
  {
    this->Engine = method;
    this->Modified();
  }

  /// Of openmesh: degrees, 0 to 180. Default: 180, no condition.
  void SetMaxNormalDeviation(double degrees)
  {
    this->Conditions.maxNormalDeviation = degrees;
    this->Modified();
  }

  /// Of openmesh. Default: 0, no condition.
  void SetLongestEdge(const scan::Length& length)
  {
    this->LongestEdge = length;
    this->Modified();
  }

  /// Of openmesh: length over height of a triangle. Default: 0, no condition.
  void SetMaxAspectRatio(double ratio)
  {
    this->Conditions.maxAspectRatio = ratio;
    this->Modified();
  }

  /// Of the last run, without the surface.
  const scan::DecimateResult& GetResult() const { return this->Result; }

protected:
  vtkScanDecimateFilter() = default;
  ~vtkScanDecimateFilter() override = default;

  std::vector<scan::Phase> Phases() const override;
  scan::SurfaceEdit Edit(const Surface& surface, scan::Execution& execution) override;

private:
  std::size_t TargetOf(std::size_t inRegion) const;

  double Ratio = 0.0;
  vtkIdType Triangles = 0;
  Method Engine = Method::quadric;
  scan::Length LongestEdge;
  scan::DecimateOptions Options;
  scan::OpenMeshConditions Conditions;
  scan::DecimateResult Result;
};
