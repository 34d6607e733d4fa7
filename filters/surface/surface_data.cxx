// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/surface/surface_data.h"

#include "filters/base/vtkScanArrayNames.h"
#include "filters/base/vtkScanMeshBridge.h"
#include "filters/geometry/vertex_normals.h"

#include <vtkAbstractArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>
#include <vector>

namespace scan
{

namespace
{

/// An array of the same kind and name with room for so many tuples.
vtkSmartPointer<vtkAbstractArray> arrayLike(vtkAbstractArray& array, vtkIdType tuples)
{
  auto like = vtkSmartPointer<vtkAbstractArray>::Take(array.NewInstance());
  like->SetName(array.GetName());
  like->SetNumberOfComponents(array.GetNumberOfComponents());
  like->CopyComponentNames(&array);
  like->SetNumberOfTuples(tuples);
  return like;
}

/// Gives `to` every array of `from` that is not left out, filled by fill(source, target), with the
/// part it plays.
template <class Fill>
void carryArrays(vtkDataSetAttributes& from, vtkDataSetAttributes& to, vtkIdType tuples,
  std::initializer_list<std::string_view> leftOut, Fill&& fill)
{
  for (int i = 0; i < from.GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray& source = *from.GetAbstractArray(i);
    const char* const name = source.GetName();
    if (name != nullptr && std::ranges::find(leftOut, std::string_view(name)) != leftOut.end())
    {
      continue;
    }
    const auto target = arrayLike(source, tuples);
    fill(source, *target);
    const int place = to.AddArray(target);
    if (const int part = from.IsArrayAnAttribute(i); part >= 0)
    {
      to.SetActiveAttribute(place, part);
    }
  }
}

bool isBlended(vtkAbstractArray& array)
{
  const int type = array.GetDataType();
  return type == VTK_FLOAT || type == VTK_DOUBLE || type == VTK_UNSIGNED_CHAR;
}

void blendTuple(
  vtkAbstractArray& source, const PointBlend& blend, vtkIdType place, vtkAbstractArray& target)
{
  if (!isBlended(source))
  {
    const auto largest = std::ranges::max_element(blend.weights) - blend.weights.begin();
    target.SetTuple(place, blend.from.at(static_cast<std::size_t>(largest)), &source);
    return;
  }
  vtkNew<vtkIdList> from;
  std::array<double, 3> weights = blend.weights;
  for (const Index point : blend.from)
  {
    from->InsertNextId(point);
  }
  target.InterpolateTuple(place, from, &source, weights.data());
}

void carryPointData(vtkPolyData& input, const SurfaceEdit& edit, vtkPolyData& output)
{
  const auto count = static_cast<vtkIdType>(edit.mesh.points.size());
  carryArrays(*input.GetPointData(), *output.GetPointData(), count,
    { arrays::kScanPointId, arrays::kNormals },
    [&](vtkAbstractArray& source, vtkAbstractArray& target)
    {
      auto blend = edit.blends.begin();
      for (vtkIdType i = 0; i < count; ++i)
      {
        const Index origin = edit.pointOrigin[static_cast<std::size_t>(i)];
        if (origin != kNone)
        {
          target.SetTuple(i, origin, &source);
        }
        else
        {
          blendTuple(source, *blend++, i, target);
        }
      }
    });
  const std::vector<vtkIdType> inputIds = bridge::scanPointIdsOf(input);
  std::vector<vtkIdType> ids(edit.pointOrigin.size());
  std::ranges::transform(edit.pointOrigin, ids.begin(),
    [&](Index origin) { return origin == kNone ? vtkIdType{ -1 } : inputIds[origin]; });
  bridge::setScanPointIds(output, ids);
  if (input.GetPointData()->GetArray(arrays::kNormals) != nullptr)
  {
    bridge::setNormals(output, vertexNormals(edit.mesh));
  }
}

/// What a triangle has that comes from none.
double missingValueOf(vtkDataArray& array)
{
  const int type = array.GetDataType();
  if (type == VTK_FLOAT || type == VTK_DOUBLE)
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  return array.GetDataTypeMin() < 0.0 ? -1.0 : array.GetDataTypeMax();
}

void carryCellData(vtkPolyData& input, const SurfaceEdit& edit, std::span<const vtkIdType> cells,
  vtkPolyData& output)
{
  const auto count = static_cast<vtkIdType>(edit.mesh.triangles.size());
  carryArrays(*input.GetCellData(), *output.GetCellData(), count, {},
    [&](vtkAbstractArray& source, vtkAbstractArray& target)
    {
      auto* const numbers = vtkArrayDownCast<vtkDataArray>(&target);
      for (vtkIdType i = 0; i < count; ++i)
      {
        const Index origin = edit.triangleOrigin[static_cast<std::size_t>(i)];
        if (origin != kNone)
        {
          target.SetTuple(i, cells[origin], &source);
        }
        else if (numbers != nullptr)
        {
          for (int k = 0; k < numbers->GetNumberOfComponents(); ++k)
          {
            numbers->SetComponent(i, k, missingValueOf(*numbers));
          }
        }
      }
    });
}

} // namespace

void setSurface(vtkPolyData& input, const SurfaceEdit& edit, std::span<const vtkIdType> cells,
  vtkPolyData& output)
{
  bridge::setMesh(output, edit.mesh);
  carryPointData(input, edit, output);
  carryCellData(input, edit, cells, output);
}

} // namespace scan
