// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ScanFiltersModule.h" // export macro
#include "filters/base/vtkScanTask.h"

#include <vtkPolyDataAlgorithm.h>
#include <vtkSmartPointer.h>

#include <cstdint>
#include <string>
#include <vector>

/// Base of the filters from vtkPolyData to vtkPolyData: a subclass writes Run() and may throw;
/// progress, cancel and errors are taken care of here.
class SCANFILTERS_EXPORT vtkScanPolyDataFilter
  : public vtkPolyDataAlgorithm
  , public vtkScanTask
{
public:
  vtkTypeMacro(vtkScanPolyDataFilter, vtkPolyDataAlgorithm);
  vtkScanPolyDataFilter(const vtkScanPolyDataFilter&) = delete;
  void operator=(const vtkScanPolyDataFilter&) = delete;

  /// Where to work, for the filters that say so: the name of a region that the input has, or a
  /// rule. Default: empty, everywhere.
  void SetRegion(const std::string& region)
  {
    this->Region = region;
    this->Modified();
  }
  const std::string& GetRegion() const { return this->Region; }

protected:
  vtkScanPolyDataFilter() = default;
  ~vtkScanPolyDataFilter() override = default;

  /// Fills `output`, which is empty; `input` must stay as it is. The unit and the files of the
  /// input are passed on afterwards. Throws scan::Error.
  virtual void Run(vtkPolyData& input, vtkPolyData& output, scan::Execution& execution) = 0;

  /// Per point, or per triangle of bridge::meshOf(), 1 in the region and 0 elsewhere; all 1 without
  /// one. Throws scan::Error for a region that is not there or cannot be used on this input.
  std::vector<std::uint8_t> PointsInRegion(vtkPolyData& input, scan::Execution& execution) const;
  std::vector<std::uint8_t> TrianglesInRegion(vtkPolyData& input, scan::Execution& execution) const;

  /// The empty output of the next run. Default: vtkPolyData.
  virtual vtkSmartPointer<vtkPolyData> NewOutput(vtkPolyData* input);

  vtkTypeBool ProcessRequest(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) final;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) final;

private:
  std::string Region;
};
