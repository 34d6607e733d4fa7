// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/base/vtkScanPolyDataFilter.h"

#include <vtkPolyData.h>

int vtkScanPolyDataFilter::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  return this->RunGuarded(*this, output,
    [&](scan::Execution& execution)
    {
      if (input == nullptr)
      {
        throw scan::Error(scan::ErrorCode::badInput, "the input is no polygonal data");
      }
      this->Run(*input, *output, execution);
    });
}
