// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ScanFiltersModule.h" // export macro
#include "filters/base/vtkScanMeshBridge.h"
#include "filters/base/vtkScanPolyDataFilter.h"
#include "filters/geometry/mesh_checks.h"

#include <vector>

/// Measures a model and passes it on unchanged: unit, files, counts, box, holes, components, genus,
/// area, volume, edge lengths. Works on points without triangles, too. With a region it measures
/// that part: triangles of a surface, points of a scan.
class SCANFILTERS_EXPORT vtkScanInfoFilter : public vtkScanPolyDataFilter
{
public:
  static vtkScanInfoFilter* New();
  vtkTypeMacro(vtkScanInfoFilter, vtkScanPolyDataFilter);
  vtkScanInfoFilter(const vtkScanInfoFilter&) = delete;
  void operator=(const vtkScanInfoFilter&) = delete;

  /// Of the last run's input.
  const scan::MeshReport& GetReport() const { return this->Report; }

  /// Mean spacing of the last run's points, see filters/geometry/spacing.h.
  double GetSpacing() const { return this->Spacing; }

  /// Of the last run's input, in millimetres; 0 without a unit.
  double GetMillimetresPerUnit() const { return this->MillimetresPerUnit; }

  /// The number of curves of the last run's input.
  vtkIdType GetCurves() const { return this->Curves; }

  /// The files that the last run's input comes from, when there were several.
  const std::vector<scan::bridge::ScanFile>& GetFiles() const { return this->Files; }

protected:
  vtkScanInfoFilter() = default;
  ~vtkScanInfoFilter() override = default;

  vtkSmartPointer<vtkPolyData> NewOutput(vtkPolyData* input) override; ///< of the input's type
  void Run(vtkPolyData& input, vtkPolyData& output, scan::Execution& execution) override;

private:
  scan::MeshReport Report;
  double Spacing = 0.0;
  double MillimetresPerUnit = 0.0;
  vtkIdType Curves = 0;
  std::vector<scan::bridge::ScanFile> Files;
};
