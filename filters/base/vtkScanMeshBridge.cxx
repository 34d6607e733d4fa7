// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/base/vtkScanMeshBridge.h"

#include "filters/base/error.h"
#include "filters/base/vtkScanArrayNames.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <array>
#include <functional>
#include <numeric>
#include <string>

namespace scan::bridge
{

namespace
{

using Cell = std::span<const vtkIdType>;

/// Calls visit(corners) for every cell; corners are indices of existing points.
void forEachCell(
  vtkCellArray& cells, vtkIdType pointCount, const std::function<void(Cell corners)>& visit)
{
  const auto iterator = vtk::TakeSmartPointer(cells.NewIterator());
  for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    iterator->GetCurrentCell(size, ids);
    const Cell corners(ids, static_cast<std::size_t>(size));
    for (const vtkIdType id : corners)
    {
      if (id < 0 || id >= pointCount)
      {
        throw Error(ErrorCode::badInput,
          "cell " + std::to_string(iterator->GetCurrentCellId()) + " names point " +
            std::to_string(id) + " of " + std::to_string(pointCount) + "; repair the mesh first");
      }
    }
    visit(corners);
  }
}

Triangle triangleOf(vtkIdType a, vtkIdType b, vtkIdType c)
{
  return { static_cast<Index>(a), static_cast<Index>(b), static_cast<Index>(c) };
}

template <std::size_t N>
vtkSmartPointer<vtkCellArray> cellsOf(std::span<const std::array<Index, N>> cells)
{
  auto result = vtkSmartPointer<vtkCellArray>::New();
  const auto count = static_cast<vtkIdType>(cells.size());
  result->AllocateExact(count, count * static_cast<vtkIdType>(N));
  for (const std::array<Index, N>& cell : cells)
  {
    std::array<vtkIdType, N> ids{};
    std::copy(cell.begin(), cell.end(), ids.begin());
    result->InsertNextCell(static_cast<vtkIdType>(N), ids.data());
  }
  return result;
}

vtkSmartPointer<vtkCellArray> vertexPerPoint(std::size_t count)
{
  std::vector<std::array<Index, 1>> vertices(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    vertices[i] = { static_cast<Index>(i) };
  }
  return cellsOf<1>(vertices);
}

} // namespace

std::vector<Vec3> pointsOf(vtkPolyData& data)
{
  const vtkIdType count = data.GetNumberOfPoints();
  if (count >= static_cast<vtkIdType>(kNone))
  {
    throw Error(ErrorCode::limit,
      std::to_string(count) + " points are more than the 4294967294 supported; thin them first");
  }
  std::vector<Vec3> points(static_cast<std::size_t>(count));
  for (vtkIdType i = 0; i < count; ++i)
  {
    std::array<double, 3> p{};
    data.GetPoint(i, p.data());
    points[static_cast<std::size_t>(i)] = { p[0], p[1], p[2] };
  }
  return points;
}

TriMesh meshOf(vtkPolyData& data)
{
  TriMesh mesh;
  mesh.points = pointsOf(data);
  const vtkIdType pointCount = data.GetNumberOfPoints();
  forEachCell(*data.GetPolys(), pointCount,
    [&](Cell corners)
    {
      for (std::size_t i = 2; i < corners.size(); ++i)
      {
        mesh.triangles.push_back(triangleOf(corners[0], corners[i - 1], corners[i]));
      }
    });
  forEachCell(*data.GetStrips(), pointCount,
    [&](Cell corners)
    {
      for (std::size_t i = 2; i < corners.size(); ++i)
      {
        // every second triangle of a strip is stored turned over
        const std::size_t turn = i % 2;
        mesh.triangles.push_back(
          triangleOf(corners[i - 2 + turn], corners[i - 1 - turn], corners[i]));
      }
    });
  return mesh;
}

std::vector<Segment> segmentsOf(vtkPolyData& data)
{
  std::vector<Segment> segments;
  forEachCell(*data.GetLines(), data.GetNumberOfPoints(),
    [&](Cell corners)
    {
      for (std::size_t i = 1; i < corners.size(); ++i)
      {
        segments.push_back({ static_cast<Index>(corners[i - 1]), static_cast<Index>(corners[i]) });
      }
    });
  return segments;
}

void setMesh(vtkPolyData& output, const TriMesh& mesh, std::span<const Segment> lines)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(mesh.points.size()));
  vtkIdType id = 0;
  for (const Vec3& p : mesh.points)
  {
    points->SetPoint(id++, p.x, p.y, p.z);
  }
  output.Initialize();
  output.SetPoints(points);
  output.SetPolys(cellsOf<3>(mesh.triangles));
  output.SetLines(cellsOf<2>(lines));
  if (mesh.triangles.empty() && lines.empty())
  {
    output.SetVerts(vertexPerPoint(mesh.points.size()));
  }
}

std::vector<vtkIdType> scanPointIdsOf(vtkPolyData& data)
{
  std::vector<vtkIdType> ids(static_cast<std::size_t>(data.GetNumberOfPoints()));
  vtkDataArray* array = data.GetPointData()->GetArray(arrays::kScanPointId);
  if (array == nullptr)
  {
    std::iota(ids.begin(), ids.end(), 0);
    return ids;
  }
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    ids[i] = static_cast<vtkIdType>(array->GetTuple1(static_cast<vtkIdType>(i)));
  }
  return ids;
}

void setScanPointIds(vtkPolyData& output, std::span<const vtkIdType> ids)
{
  vtkNew<vtkIdTypeArray> array;
  array->SetName(arrays::kScanPointId);
  array->SetNumberOfValues(static_cast<vtkIdType>(ids.size()));
  std::copy(ids.begin(), ids.end(), array->GetPointer(0));
  output.GetPointData()->AddArray(array);
}

} // namespace scan::bridge
