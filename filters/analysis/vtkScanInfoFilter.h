// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ScanFiltersModule.h" // export macro
#include "filters/base/vtkScanPolyDataFilter.h"
#include "filters/geometry/mesh_checks.h"

/// Measures a model and passes it on unchanged: counts, box, holes, components, genus, area,
/// volume, edge lengths. Works on points without triangles, too.
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

protected:
  vtkScanInfoFilter() = default;
  ~vtkScanInfoFilter() override = default;

  vtkSmartPointer<vtkPolyData> NewOutput(vtkPolyData* input) override; ///< of the input's type
  void Run(vtkPolyData& input, vtkPolyData& output, scan::Execution& execution) override;

private:
  scan::MeshReport Report;
  double Spacing = 0.0;
};
