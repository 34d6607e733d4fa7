// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/surface/vtkScanRefineFilter.h"

#include "filters/base/vtkScanArrayNames.h"

#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <utility>

vtkStandardNewMacro(vtkScanRefineFilter);

namespace
{

/// The marks of the triangles; none where the array is missing or of another kind.
std::vector<std::uint8_t> halvesOf(vtkPolyData& data, const std::vector<vtkIdType>& cells)
{
  auto* const array = vtkArrayDownCast<vtkUnsignedCharArray>(
    data.GetCellData()->GetAbstractArray(scan::arrays::kHalf));
  std::vector<std::uint8_t> halves;
  if (array == nullptr || array->GetNumberOfComponents() != 1)
  {
    return halves;
  }
  halves.resize(cells.size());
  std::ranges::transform(
    cells, halves.begin(), [array](vtkIdType cell) { return array->GetValue(cell); });
  return halves;
}

} // namespace

std::vector<scan::Phase> vtkScanRefineFilter::Phases() const
{
  return { { "refine", 0.2 } };
}

scan::SurfaceEdit vtkScanRefineFilter::Edit(const Surface& surface, scan::Execution& execution)
{
  const std::vector<std::uint8_t> inRegion = this->TrianglesInRegion(surface, execution);
  scan::RefineOptions options = this->Options;
  options.maxDeviation = surface.maxDeviation;
  this->Result =
    scan::refine(surface.mesh, inRegion, halvesOf(surface.data, surface.cells), options, execution);
  scan::SurfaceEdit edit = std::exchange(this->Result.edit, {});
  this->PointsAdded = static_cast<vtkIdType>(edit.blends.size());
  return edit;
}

void vtkScanRefineFilter::Finish(vtkPolyData& output)
{
  output.GetCellData()->RemoveArray(scan::arrays::kHalf);
  const std::vector<std::uint8_t> halves = std::exchange(this->Result.halves, {});
  if (std::ranges::any_of(halves, [](std::uint8_t half) { return half != 0; }))
  {
    vtkNew<vtkUnsignedCharArray> array;
    array->SetName(scan::arrays::kHalf);
    array->SetNumberOfValues(static_cast<vtkIdType>(halves.size()));
    std::ranges::copy(halves, array->GetPointer(0));
    output.GetCellData()->AddArray(array);
  }
}
