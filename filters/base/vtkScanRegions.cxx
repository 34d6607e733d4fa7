// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/base/vtkScanRegions.h"

#include "filters/base/error.h"
#include "filters/base/vtkScanArrayNames.h"
#include "filters/base/vtkScanMeshBridge.h"
#include "filters/geometry/region.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>

#include <cmath>

namespace scan::bridge
{

namespace
{

/// The array of that name with one tuple an element, or null.
vtkDataArray* arrayOf(vtkFieldData& data, const std::string& name, vtkIdType elements)
{
  vtkDataArray* const array = data.GetArray(name.c_str());
  return array != nullptr && array->GetNumberOfTuples() >= elements ? array : nullptr;
}

double valueAt(vtkDataArray& array, vtkIdType tuple)
{
  if (array.GetNumberOfComponents() == 1)
  {
    return array.GetComponent(tuple, 0);
  }
  double squares = 0.0;
  for (int i = 0; i < array.GetNumberOfComponents(); ++i)
  {
    squares += array.GetComponent(tuple, i) * array.GetComponent(tuple, i);
  }
  return std::sqrt(squares);
}

[[noreturn]] void refuseArray(vtkPolyData& data, const std::string& name)
{
  std::string others;
  for (vtkFieldData* const fields : { static_cast<vtkFieldData*>(data.GetPointData()),
         static_cast<vtkFieldData*>(data.GetCellData()) })
  {
    for (int i = 0; i < fields->GetNumberOfArrays(); ++i)
    {
      const char* const other = fields->GetArrayName(i);
      others += (others.empty() ? "; it has " : ", ") + std::string(other != nullptr ? other : "");
    }
  }
  throw Error(ErrorCode::badParameter, "region: the model has no array " + name + others);
}

/// Per point.
std::vector<double> valuesOfPoints(vtkPolyData& data, const std::string& name)
{
  const vtkIdType count = data.GetNumberOfPoints();
  vtkDataArray* const array = arrayOf(*data.GetPointData(), name, count);
  if (array == nullptr)
  {
    refuseArray(data, name);
  }
  std::vector<double> values;
  for (vtkIdType i = 0; i < count; ++i)
  {
    values.push_back(valueAt(*array, i));
  }
  return values;
}

/// Per triangle.
/// @param cells the cell of each
std::vector<double> valuesOfTriangles(vtkPolyData& data, const TriMesh& mesh,
  const std::vector<vtkIdType>& cells, const std::string& name)
{
  std::vector<double> values;
  if (vtkDataArray* const array = arrayOf(*data.GetCellData(), name, data.GetNumberOfCells()))
  {
    for (const vtkIdType cell : cells)
    {
      values.push_back(valueAt(*array, cell));
    }
    return values;
  }
  const std::vector<double> atPoints = valuesOfPoints(data, name);
  for (const auto& [a, b, c] : mesh.triangles)
  {
    values.push_back((atPoints[a] + atPoints[b] + atPoints[c]) / 3.0);
  }
  return values;
}

vtkStringArray* textsOf(vtkDataObject& data, const char* name)
{
  return vtkStringArray::SafeDownCast(data.GetFieldData()->GetAbstractArray(name));
}

} // namespace

RegionNames regionsOf(vtkDataObject& data)
{
  vtkStringArray* const names = textsOf(data, arrays::kRegionNames);
  vtkStringArray* const rules = textsOf(data, arrays::kRegionRules);
  RegionNames regions;
  if (names != nullptr && rules != nullptr)
  {
    for (vtkIdType i = 0; i < std::min(names->GetNumberOfValues(), rules->GetNumberOfValues()); ++i)
    {
      regions[names->GetValue(i)] = parseRegionRule(rules->GetValue(i));
    }
  }
  return regions;
}

void setRegion(vtkDataObject& data, const std::string& name, const RegionRule& rule)
{
  RegionNames regions = regionsOf(data);
  regions[name] = rule;
  vtkNew<vtkStringArray> names;
  vtkNew<vtkStringArray> rules;
  names->SetName(arrays::kRegionNames);
  rules->SetName(arrays::kRegionRules);
  for (const auto& [key, value] : regions)
  {
    names->InsertNextValue(key);
    rules->InsertNextValue(textOf(value));
  }
  data.GetFieldData()->AddArray(names);
  data.GetFieldData()->AddArray(rules);
}

std::vector<std::uint8_t> pointsInRegion(
  vtkPolyData& data, const std::string& region, Execution& execution)
{
  const RegionRule rule = parseRegionRule(region, regionsOf(data));
  const TriMesh mesh = meshOf(data);
  const RegionDomain domain{ mesh, RegionElements::points, unitOf(data),
    [&](const std::string& name) { return valuesOfPoints(data, name); } };
  return chooseElements(rule, domain, execution);
}

std::vector<std::uint8_t> trianglesInRegion(
  vtkPolyData& data, const std::string& region, Execution& execution)
{
  const RegionRule rule = parseRegionRule(region, regionsOf(data));
  std::vector<vtkIdType> cells;
  const TriMesh mesh = meshOf(data, &cells);
  const RegionDomain domain{ mesh, RegionElements::triangles, unitOf(data),
    [&](const std::string& name) { return valuesOfTriangles(data, mesh, cells, name); } };
  return chooseElements(rule, domain, execution);
}

void keepRegion(vtkPolyData& input, const std::string& region, bool isInside, vtkPolyData& output,
  Execution& execution)
{
  const bool isSurface = hasTriangles(input);
  std::vector<std::uint8_t> isKept = isSurface ? trianglesInRegion(input, region, execution)
                                               : pointsInRegion(input, region, execution);
  for (std::uint8_t& flag : isKept)
  {
    flag = (flag != 0) == isInside ? 1 : 0;
  }
  isSurface ? keepTriangles(input, isKept, output) : keepPoints(input, isKept, output);
  passOrigin(input, output);
}

vtkSmartPointer<vtkPolyData> partOf(
  vtkPolyData& input, const std::string& region, Execution& execution)
{
  if (region.empty())
  {
    return &input;
  }
  auto part = vtkSmartPointer<vtkPolyData>::New();
  keepRegion(input, region, true, *part, execution);
  return part;
}

} // namespace scan::bridge
