// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/points/vtkScanAddPointsFilter.h"

#include "filters/base/vtkScanArrayNames.h"
#include "filters/base/vtkScanMeshBridge.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <numeric>

vtkStandardNewMacro(vtkScanAddPointsFilter);

namespace
{

/// The data of the points, and for those behind it zeros, but white.
void extendData(vtkPointData& from, vtkIdType before, vtkIdType after, vtkPointData& to)
{
  vtkNew<vtkIdList> ids;
  ids->SetNumberOfIds(before);
  std::iota(ids->begin(), ids->end(), vtkIdType{ 0 });
  to.CopyAllOn();
  to.CopyAllocate(&from, after);
  to.CopyData(&from, ids, ids);
  vtkDataArray* const colors = to.GetArray(scan::arrays::kColors);
  for (vtkIdType id = before; id < after; ++id)
  {
    to.NullData(id);
    for (int channel = 0; colors != nullptr && channel < colors->GetNumberOfComponents(); ++channel)
    {
      colors->SetComponent(id, channel, 255);
    }
  }
}

} // namespace

void vtkScanAddPointsFilter::Run(
  vtkPolyData& input, vtkPolyData& output, scan::Execution& execution)
{
  execution.step("add", 0, 1);
  std::vector<scan::Vec3> points = scan::bridge::pointsOf(input);
  std::vector<vtkIdType> ids = scan::bridge::scanPointIdsOf(input);
  vtkIdType next = ids.empty() ? 0 : *std::ranges::max_element(ids) + 1;
  for (scan::Vec3 point : this->Points)
  {
    if (this->Depth)
    {
      (this->Axis == X ? point.x : this->Axis == Y ? point.y : point.z) = *this->Depth;
    }
    points.push_back(point);
    ids.push_back(next++);
  }
  scan::bridge::setMesh(output, { points, {} });
  if (input.GetNumberOfLines() + input.GetNumberOfPolys() + input.GetNumberOfStrips() > 0)
  {
    output.SetVerts(input.GetVerts());
    output.SetLines(input.GetLines());
    output.SetPolys(input.GetPolys());
    output.SetStrips(input.GetStrips());
    output.GetCellData()->ShallowCopy(input.GetCellData());
  }
  extendData(*input.GetPointData(), input.GetNumberOfPoints(), output.GetNumberOfPoints(),
    *output.GetPointData());
  scan::bridge::setScanPointIds(output, ids);
  this->PointsBefore = input.GetNumberOfPoints();
  this->PointsAfter = output.GetNumberOfPoints();
  if (this->Points.empty())
  {
    this->AddNote("nothing changed");
  }
}
