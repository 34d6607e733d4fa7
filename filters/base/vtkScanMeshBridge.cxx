// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/base/vtkScanMeshBridge.h"

#include "filters/base/error.h"
#include "filters/base/vtkScanArrayNames.h"
#include "filters/geometry/polygon.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkTypeInt32Array.h>
#include <vtkTypeInt64Array.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <functional>
#include <iterator>
#include <limits>
#include <numeric>
#include <string>
#include <type_traits>

namespace scan::bridge
{

namespace
{

using Cell = std::span<const vtkIdType>;

static_assert(sizeof(Vec3) == 3 * sizeof(double)); // tuples of VTK are copied whole

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

void append(std::vector<Index>& indices, Cell ids)
{
  std::ranges::transform(
    ids, std::back_inserter(indices), [](vtkIdType id) { return static_cast<Index>(id); });
}

Triangle triangleOf(vtkIdType a, vtkIdType b, vtkIdType c)
{
  return { static_cast<Index>(a), static_cast<Index>(b), static_cast<Index>(c) };
}

template <class IdArray, std::size_t N>
vtkSmartPointer<vtkCellArray> cellsWith(std::span<const std::array<Index, N>> cells)
{
  using Id = typename IdArray::ValueType;
  vtkNew<IdArray> offsets;
  vtkNew<IdArray> connectivity;
  const auto count = static_cast<vtkIdType>(cells.size());
  constexpr auto kCorners = static_cast<vtkIdType>(N);
  offsets->SetNumberOfValues(count + 1);
  connectivity->SetNumberOfValues(kCorners * count);
  Id* offset = offsets->GetPointer(0);
  Id* id = connectivity->GetPointer(0);
  for (vtkIdType i = 0; i <= count; ++i)
  {
    offset[i] = static_cast<Id>(kCorners * i);
  }
  for (const std::array<Index, N>& cell : cells)
  {
    id = std::transform(cell.begin(), cell.end(), id, [](Index i) { return static_cast<Id>(i); });
  }
  auto result = vtkSmartPointer<vtkCellArray>::New();
  result->SetData(offsets, connectivity);
  return result;
}

/// Cells of N corners each, with ids of 32 bits where they fit: half the memory.
template <std::size_t N>
vtkSmartPointer<vtkCellArray> cellsOf(
  std::span<const std::array<Index, N>> cells, std::size_t pointCount)
{
  constexpr std::size_t kMost = std::numeric_limits<vtkTypeInt32>::max();
  return pointCount <= kMost && N * cells.size() <= kMost ? cellsWith<vtkTypeInt32Array, N>(cells)
                                                          : cellsWith<vtkTypeInt64Array, N>(cells);
}

/// Appends cells that are all triangles; false, and nothing appended, when an id is out of range.
template <class Id>
bool appendTriangles(
  std::span<const Id> ids, vtkIdType pointCount, std::vector<Triangle>& triangles)
{
  if (std::ranges::any_of(
        ids, [&](Id id) { return id < 0 || static_cast<vtkIdType>(id) >= pointCount; }))
  {
    return false;
  }
  triangles.reserve(triangles.size() + ids.size() / 3);
  for (std::size_t i = 0; i + 3 <= ids.size(); i += 3)
  {
    triangles.push_back(triangleOf(ids[i], ids[i + 1], ids[i + 2]));
  }
  return true;
}

bool appendTriangles(vtkCellArray& cells, vtkIdType pointCount, std::vector<Triangle>& triangles)
{
  if (cells.IsHomogeneous() != 3)
  {
    return false;
  }
  const auto append = [&](auto* connectivity)
  {
    using Id = typename std::remove_pointer_t<decltype(connectivity)>::ValueType;
    const auto size = static_cast<std::size_t>(connectivity->GetNumberOfValues());
    return appendTriangles(
      std::span<const Id>(connectivity->GetPointer(0), size), pointCount, triangles);
  };
  return cells.IsStorage64Bit() ? append(cells.GetConnectivityArray64())
                                : append(cells.GetConnectivityArray32());
}

vtkSmartPointer<vtkCellArray> cellsOf(const Polylines& lines)
{
  vtkNew<vtkTypeInt64Array> offsets;
  vtkNew<vtkTypeInt64Array> connectivity;
  offsets->SetNumberOfValues(static_cast<vtkIdType>(lines.size()) + 1);
  connectivity->SetNumberOfValues(static_cast<vtkIdType>(lines.corners.size()));
  vtkTypeInt64* const first = offsets->GetPointer(0);
  first[0] = 0;
  std::ranges::copy(lines.ends, first + 1);
  std::ranges::copy(lines.corners, connectivity->GetPointer(0));
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(offsets, connectivity);
  return cells;
}

Polylines polylinesOf(vtkPolyData& data)
{
  Polylines lines;
  forEachCell(*data.GetLines(), data.GetNumberOfPoints(),
    [&](Cell corners)
    {
      append(lines.corners, corners);
      lines.endLine();
    });
  return lines;
}

vtkSmartPointer<vtkDoubleArray> tuplesOf(const std::vector<Vec3>& vectors, const char* name)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(static_cast<vtkIdType>(vectors.size()));
  if (!vectors.empty())
  {
    std::memcpy(array->GetPointer(0), vectors.data(), sizeof(Vec3) * vectors.size());
  }
  return array;
}

void setPoints(vtkPolyData& output, const std::vector<Vec3>& positions)
{
  vtkNew<vtkPoints> points;
  points->SetData(tuplesOf(positions, "Points"));
  output.SetPoints(points);
}

vtkSmartPointer<vtkCellArray> vertexPerPoint(std::size_t count)
{
  std::vector<std::array<Index, 1>> vertices(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    vertices[i] = { static_cast<Index>(i) };
  }
  return cellsOf<1>(vertices, count);
}

/// The cells without a dropped point, by the new numbers of their points.
/// @param first the number of the first cell among all
/// @param kept receives the numbers of the cells that stay
vtkSmartPointer<vtkCellArray> keptCells(
  vtkCellArray& cells, const std::vector<vtkIdType>& numbers, vtkIdType first, vtkIdList& kept)
{
  auto result = vtkSmartPointer<vtkCellArray>::New();
  std::vector<vtkIdType> renumbered;
  vtkIdType cell = first;
  forEachCell(cells, static_cast<vtkIdType>(numbers.size()),
    [&](Cell corners)
    {
      renumbered.clear();
      std::ranges::transform(corners, std::back_inserter(renumbered),
        [&](vtkIdType id) { return numbers[static_cast<std::size_t>(id)]; });
      if (std::ranges::find(renumbered, -1) == renumbered.end())
      {
        result->InsertNextCell(static_cast<vtkIdType>(renumbered.size()), renumbered.data());
        kept.InsertNextId(cell);
      }
      ++cell;
    });
  return result;
}

void copyData(vtkDataSetAttributes& from, vtkIdList& ids, vtkDataSetAttributes& to)
{
  vtkNew<vtkIdList> places;
  places->SetNumberOfIds(ids.GetNumberOfIds());
  std::iota(places->begin(), places->end(), vtkIdType{ 0 });
  to.CopyAllOn();
  to.CopyAllocate(&from, ids.GetNumberOfIds());
  to.CopyData(&from, &ids, places);
}

/// Gives `output` the points of `input` that are kept, with their data and scan-point ids.
/// @return per point of `input` its new number, -1 where it is gone
std::vector<vtkIdType> copyPoints(
  vtkPolyData& input, std::span<const std::uint8_t> isKept, vtkPolyData& output)
{
  output.Initialize();
  vtkNew<vtkIdList> points;
  std::vector<vtkIdType> numbers(isKept.size(), -1);
  for (std::size_t i = 0; i < isKept.size(); ++i)
  {
    if (isKept[i] != 0)
    {
      numbers[i] = points->InsertNextId(static_cast<vtkIdType>(i));
    }
  }
  const std::vector<Vec3> all = pointsOf(input);
  const std::vector<vtkIdType> allIds = scanPointIdsOf(input);
  std::vector<Vec3> positions;
  std::vector<vtkIdType> ids;
  for (const vtkIdType point : *points)
  {
    positions.push_back(all[static_cast<std::size_t>(point)]);
    ids.push_back(allIds[static_cast<std::size_t>(point)]);
  }
  setPoints(output, positions);
  copyData(*input.GetPointData(), *points, *output.GetPointData());
  setScanPointIds(output, ids);
  return numbers;
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
  auto* doubles =
    count > 0 ? vtkArrayDownCast<vtkDoubleArray>(data.GetPoints()->GetData()) : nullptr;
  if (doubles != nullptr)
  {
    std::memcpy(
      static_cast<void*>(points.data()), doubles->GetPointer(0), sizeof(Vec3) * points.size());
    return points;
  }
  for (vtkIdType i = 0; i < count; ++i)
  {
    std::array<double, 3> p{};
    data.GetPoint(i, p.data());
    points[static_cast<std::size_t>(i)] = { p[0], p[1], p[2] };
  }
  return points;
}

TriMesh meshOf(vtkPolyData& data, std::vector<vtkIdType>* cells)
{
  TriMesh mesh;
  mesh.points = pointsOf(data);
  const vtkIdType pointCount = data.GetNumberOfPoints();
  vtkIdType cell = data.GetNumberOfVerts() + data.GetNumberOfLines();
  if (cells != nullptr)
  {
    cells->clear();
  }
  const auto endCell = [&]()
  {
    if (cells != nullptr)
    {
      cells->resize(mesh.triangles.size(), cell);
    }
    ++cell;
  };
  std::vector<Index> corners;
  if (!appendTriangles(*data.GetPolys(), pointCount, mesh.triangles))
  {
    forEachCell(*data.GetPolys(), pointCount,
      [&](Cell polygon)
      {
        corners.clear();
        append(corners, polygon);
        appendPolygon(mesh.triangles, mesh.points, corners);
        endCell();
      });
  }
  else if (cells != nullptr)
  {
    cells->resize(mesh.triangles.size());
    std::iota(cells->begin(), cells->end(), cell);
    cell += static_cast<vtkIdType>(cells->size());
  }
  forEachCell(*data.GetStrips(), pointCount,
    [&](Cell strip)
    {
      corners.clear();
      append(corners, strip);
      appendStrip(mesh.triangles, corners);
      endCell();
    });
  return mesh;
}

bool hasTriangles(vtkPolyData& data)
{
  return data.GetNumberOfPolys() > 0 || data.GetNumberOfStrips() > 0;
}

vtkIdType triangleCountOf(vtkPolyData& data)
{
  return static_cast<vtkIdType>(meshOf(data).triangles.size());
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
  output.Initialize();
  setPoints(output, mesh.points);
  output.SetPolys(cellsOf<3>(mesh.triangles, mesh.points.size()));
  output.SetLines(cellsOf<2>(lines, mesh.points.size()));
  if (mesh.triangles.empty() && lines.empty())
  {
    output.SetVerts(vertexPerPoint(mesh.points.size()));
  }
}

Model modelOf(vtkPolyData& data)
{
  Model model{ meshOf(data), polylinesOf(data) };
  vtkPointData& attributes = *data.GetPointData();
  const auto tuple = [&](vtkDataArray* array, std::size_t i)
  {
    std::array<double, 3> values{};
    array->GetTuple(static_cast<vtkIdType>(i), values.data());
    return values;
  };
  const auto isTriple = [&](vtkDataArray* array)
  {
    return array != nullptr && array->GetNumberOfComponents() == 3 &&
      array->GetNumberOfTuples() == data.GetNumberOfPoints();
  };
  if (vtkDataArray* array = attributes.GetArray(arrays::kColors); isTriple(array))
  {
    model.colors.resize(model.points.size());
    for (std::size_t i = 0; i < model.colors.size(); ++i)
    {
      std::ranges::transform(tuple(array, i), model.colors[i].begin(),
        [](double value) { return static_cast<std::uint8_t>(std::clamp(value, 0.0, 255.0)); });
    }
  }
  model.normals = normalsOf(data);
  model.millimetresPerUnit = unitOf(data);
  return model;
}

void setModel(vtkPolyData& output, const Model& model)
{
  output.Initialize();
  setPoints(output, model.points);
  output.SetPolys(cellsOf<3>(model.triangles, model.points.size()));
  output.SetLines(cellsOf(model.curves));
  if (model.isScan())
  {
    output.SetVerts(vertexPerPoint(model.points.size()));
  }
  const auto count = static_cast<vtkIdType>(model.points.size());
  if (!model.colors.empty())
  {
    vtkNew<vtkUnsignedCharArray> colors;
    colors->SetName(arrays::kColors);
    colors->SetNumberOfComponents(3);
    colors->SetNumberOfTuples(count);
    std::memcpy(colors->GetPointer(0), model.colors.data(), sizeof(Color) * model.colors.size());
    output.GetPointData()->SetScalars(colors);
  }
  if (!model.normals.empty())
  {
    setNormals(output, model.normals);
  }
  if (model.millimetresPerUnit > 0.0)
  {
    setUnit(output, model.millimetresPerUnit);
  }
}

void keepPoints(vtkPolyData& input, std::span<const std::uint8_t> isKept, vtkPolyData& output)
{
  const std::vector<vtkIdType> numbers = copyPoints(input, isKept, output);
  vtkNew<vtkIdList> cells;
  vtkIdType first = input.GetNumberOfVerts();
  output.SetLines(keptCells(*input.GetLines(), numbers, first, *cells));
  first += input.GetNumberOfLines();
  output.SetPolys(keptCells(*input.GetPolys(), numbers, first, *cells));
  first += input.GetNumberOfPolys();
  output.SetStrips(keptCells(*input.GetStrips(), numbers, first, *cells));
  if (cells->GetNumberOfIds() == 0)
  {
    output.SetVerts(vertexPerPoint(static_cast<std::size_t>(output.GetNumberOfPoints())));
    return;
  }
  copyData(*input.GetCellData(), *cells, *output.GetCellData());
}

void keepTriangles(vtkPolyData& input, std::span<const std::uint8_t> isKept, vtkPolyData& output)
{
  std::vector<vtkIdType> cellOf;
  const TriMesh mesh = meshOf(input, &cellOf);
  std::vector<std::uint8_t> isUsed(mesh.points.size(), 0);
  for (std::size_t t = 0; t < isKept.size(); ++t)
  {
    for (const Index corner : mesh.triangles[t])
    {
      isUsed[corner] |= isKept[t];
    }
  }
  const std::vector<vtkIdType> numbers = copyPoints(input, isUsed, output);
  vtkNew<vtkIdList> cells;
  output.SetLines(keptCells(*input.GetLines(), numbers, input.GetNumberOfVerts(), *cells));
  std::vector<Triangle> triangles;
  for (std::size_t t = 0; t < isKept.size(); ++t)
  {
    if (isKept[t] != 0)
    {
      const auto& [a, b, c] = mesh.triangles[t];
      triangles.push_back(triangleOf(numbers[a], numbers[b], numbers[c]));
      cells->InsertNextId(cellOf[t]);
    }
  }
  output.SetPolys(cellsOf<3>(triangles, mesh.points.size()));
  copyData(*input.GetCellData(), *cells, *output.GetCellData());
}

void movePoints(vtkPolyData& input, const std::vector<Vec3>& points, vtkPolyData& output)
{
  output.Initialize();
  output.CopyStructure(&input);
  setPoints(output, points);
  output.GetPointData()->ShallowCopy(input.GetPointData());
  output.GetCellData()->ShallowCopy(input.GetCellData());
}

std::vector<Vec3> normalsOf(vtkPolyData& data)
{
  vtkDataArray* const array = data.GetPointData()->GetNormals();
  if (array == nullptr || array->GetNumberOfComponents() != 3 ||
    array->GetNumberOfTuples() != data.GetNumberOfPoints())
  {
    return {};
  }
  std::vector<Vec3> normals(static_cast<std::size_t>(array->GetNumberOfTuples()));
  for (std::size_t i = 0; i < normals.size(); ++i)
  {
    std::array<double, 3> n{};
    array->GetTuple(static_cast<vtkIdType>(i), n.data());
    normals[i] = { n[0], n[1], n[2] };
  }
  return normals;
}

void setNormals(vtkPolyData& output, const std::vector<Vec3>& normals)
{
  output.GetPointData()->SetNormals(tuplesOf(normals, arrays::kNormals));
}

double unitOf(vtkDataObject& data)
{
  vtkDataArray* const unit = data.GetFieldData()->GetArray(arrays::kMillimetresPerUnit);
  return unit != nullptr && unit->GetNumberOfTuples() > 0 ? unit->GetTuple1(0) : 0.0;
}

void setUnit(vtkDataObject& data, double millimetres)
{
  vtkNew<vtkDoubleArray> unit;
  unit->SetName(arrays::kMillimetresPerUnit);
  unit->InsertNextValue(millimetres);
  data.GetFieldData()->AddArray(unit);
}

void passOrigin(vtkDataObject& input, vtkDataObject& output)
{
  for (const char* const name : { arrays::kMillimetresPerUnit, arrays::kScanFileNames,
         arrays::kScanFileEnds, arrays::kRegionNames, arrays::kRegionRules })
  {
    vtkAbstractArray* const array = input.GetFieldData()->GetAbstractArray(name);
    if (array != nullptr && output.GetFieldData()->HasArray(name) == 0)
    {
      output.GetFieldData()->AddArray(array);
    }
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

std::vector<ScanFile> scanFilesOf(vtkPolyData& data)
{
  vtkFieldData& fields = *data.GetFieldData();
  auto* const names = vtkStringArray::SafeDownCast(fields.GetAbstractArray(arrays::kScanFileNames));
  vtkDataArray* const ends = fields.GetArray(arrays::kScanFileEnds);
  if (names == nullptr || ends == nullptr ||
    names->GetNumberOfValues() != ends->GetNumberOfTuples())
  {
    return {};
  }
  std::vector<ScanFile> files(static_cast<std::size_t>(ends->GetNumberOfTuples()));
  for (std::size_t i = 0; i < files.size(); ++i)
  {
    files[i].name = names->GetValue(static_cast<vtkIdType>(i));
  }
  for (const Index file : scanFileOfPoints(data))
  {
    if (file < files.size())
    {
      ++files[file].points;
    }
  }
  return files;
}

std::vector<Index> scanFileOfPoints(vtkPolyData& data)
{
  vtkDataArray* const ends = data.GetFieldData()->GetArray(arrays::kScanFileEnds);
  std::vector<vtkIdType> behind;
  for (vtkIdType i = 0; ends != nullptr && i < ends->GetNumberOfTuples(); ++i)
  {
    behind.push_back(static_cast<vtkIdType>(ends->GetTuple1(i)));
  }
  std::vector<Index> files;
  for (const vtkIdType id : scanPointIdsOf(data))
  {
    const auto file = std::ranges::upper_bound(behind, id);
    files.push_back(file != behind.end() ? static_cast<Index>(file - behind.begin()) : kNone);
  }
  return files;
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
