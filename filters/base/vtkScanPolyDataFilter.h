// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ScanFiltersModule.h" // export macro
#include "filters/base/vtkScanTask.h"

#include <vtkPolyDataAlgorithm.h>
#include <vtkSmartPointer.h>

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

protected:
  vtkScanPolyDataFilter() = default;
  ~vtkScanPolyDataFilter() override = default;

  /// Fills `output`, which is empty; `input` must stay as it is. The unit and the files of the
  /// input are passed on afterwards. Throws scan::Error.
  virtual void Run(vtkPolyData& input, vtkPolyData& output, scan::Execution& execution) = 0;

  /// The empty output of the next run. Default: vtkPolyData.
  virtual vtkSmartPointer<vtkPolyData> NewOutput(vtkPolyData* input);

  vtkTypeBool ProcessRequest(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) final;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) final;
};
