// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/surface/folded_region.h"

#include "filters/base/vtkScanArrayNames.h"
#include "filters/base/vtkScanRegions.h"

#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>

namespace scan
{
namespace
{

constexpr const char* kRegion = "folded";

} // namespace

void markFolds(const SurfaceFolds& folds, vtkPolyData& output)
{
  output.GetCellData()->RemoveArray(arrays::kFolded); // of an earlier operation
  if (folds.folded == 0)
  {
    bridge::setRegion(output, kRegion, parseRegionRule("none"));
    return;
  }
  vtkNew<vtkUnsignedCharArray> isFolded;
  isFolded->SetName(arrays::kFolded);
  isFolded->SetNumberOfValues(static_cast<vtkIdType>(folds.isFolded.size()));
  std::ranges::copy(folds.isFolded, isFolded->GetPointer(0));
  output.GetCellData()->AddArray(isFolded);
  bridge::setRegion(
    output, kRegion, parseRegionRule(std::string("array(").append(arrays::kFolded) + ",1,1)"));
}

std::string describe(const SurfaceFolds& folds)
{
  if (folds.folded == 0)
  {
    return {};
  }
  std::string text = "folds onto itself in " + std::to_string(folds.places.size());
  text += folds.places.size() == 1 ? " place" : " places";
  text += ", " + std::to_string(folds.folded) + " triangles: the region folded";
  return text;
}

} // namespace scan
