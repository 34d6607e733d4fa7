// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/merge_models.h"

#include <vtkAppendPolyData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

namespace scan
{

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
  return append->GetOutput();
}

} // namespace scan
