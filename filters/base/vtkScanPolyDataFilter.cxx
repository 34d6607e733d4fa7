// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/base/vtkScanPolyDataFilter.h"

#include "filters/base/vtkScanMeshBridge.h"
#include "filters/base/vtkScanRegions.h"

#include <vtkDemandDrivenPipeline.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkPolyData.h>

vtkSmartPointer<vtkPolyData> vtkScanPolyDataFilter::NewOutput(vtkPolyData*)
{
  return vtkSmartPointer<vtkPolyData>::New();
}

std::vector<std::uint8_t> vtkScanPolyDataFilter::PointsInRegion(
  vtkPolyData& input, scan::Execution& execution) const
{
  if (this->Region.empty() && !scan::bridge::hasTriangles(input))
  {
    return std::vector<std::uint8_t>(static_cast<std::size_t>(input.GetNumberOfPoints()), 1);
  }
  return scan::bridge::pointsInRegion(
    input, this->Region.empty() ? "all" : this->Region, execution);
}

std::vector<std::uint8_t> vtkScanPolyDataFilter::TrianglesInRegion(
  vtkPolyData& input, scan::Execution& execution) const
{
  return scan::bridge::trianglesInRegion(
    input, this->Region.empty() ? "all" : this->Region, execution);
}

vtkTypeBool vtkScanPolyDataFilter::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (request->Has(vtkDemandDrivenPipeline::REQUEST_DATA_OBJECT()))
  {
    const auto output = this->NewOutput(vtkPolyData::GetData(inputVector[0]));
    vtkPolyData* const existing = vtkPolyData::GetData(outputVector);
    if (existing == nullptr || !existing->IsA(output->GetClassName()))
    {
      outputVector->GetInformationObject(0)->Set(vtkDataObject::DATA_OBJECT(), output);
    }
    return 1;
  }
  return this->Superclass::ProcessRequest(request, inputVector, outputVector);
}

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
      scan::bridge::passOrigin(*input, *output);
    });
}
