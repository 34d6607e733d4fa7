// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/merge_models.h"

#include "filters/base/error.h"
#include "filters/base/vtkScanArrayNames.h"

#include <vtkAppendPolyData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

namespace scan
{
namespace
{

double unitOf(vtkPolyData& model)
{
  vtkDataArray* const unit = model.GetFieldData()->GetArray(arrays::kMillimetresPerUnit);
  return unit != nullptr && unit->GetNumberOfTuples() > 0 ? unit->GetTuple1(0) : 0.0;
}

} // namespace

vtkSmartPointer<vtkPolyData> mergeModels(const std::vector<vtkSmartPointer<vtkPolyData>>& parts)
{
  if (parts.size() == 1)
  {
    return parts.front();
  }
  vtkNew<vtkAppendPolyData> append;
  append->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  for (const auto& part : parts)
  {
    append->AddInputData(part);
  }
  append->Update();
  const vtkSmartPointer<vtkPolyData> merged = append->GetOutput();
  for (const auto& part : parts)
  {
    if (unitOf(*part) != unitOf(*parts.front()))
    {
      throw Error(ErrorCode::badInput,
        "the files have different units, or only some name theirs; save them in one format first");
    }
  }
  if (vtkDataArray* const unit =
        parts.front()->GetFieldData()->GetArray(arrays::kMillimetresPerUnit))
  {
    merged->GetFieldData()->AddArray(unit);
  }
  return merged;
}

} // namespace scan
