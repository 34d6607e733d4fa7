// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/input_models.h"

#include "filters/base/error.h"
#include "filters/base/note.h"
#include "filters/base/unit.h"
#include "filters/base/vtkScanArrayNames.h"
#include "filters/base/vtkScanMeshBridge.h"
#include "readers/mapped_file.h"

#include <vtkAppendPolyData.h>
#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkReverseSense.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

namespace scan
{
namespace
{

vtkSmartPointer<vtkPolyData> copyOf(vtkPolyData& data)
{
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->ShallowCopy(&data);
  return copy;
}

/// The points of the data, each changed.
template <class Change>
void setPoints(vtkPolyData& data, const Change& change)
{
  std::vector<Vec3> points = bridge::pointsOf(data);
  vtkNew<vtkDoubleArray> coordinates;
  coordinates->SetNumberOfComponents(3);
  coordinates->SetNumberOfTuples(static_cast<vtkIdType>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const Vec3 p = change(points[i]);
    coordinates->SetTuple3(static_cast<vtkIdType>(i), p.x, p.y, p.z);
  }
  vtkNew<vtkPoints> changed;
  changed->SetData(coordinates);
  data.SetPoints(changed);
}

void turnNormals(vtkPolyData& data, const Affine& place)
{
  vtkDataArray* const normals = data.GetPointData()->GetNormals();
  if (normals == nullptr)
  {
    return;
  }
  vtkNew<vtkDoubleArray> turned;
  turned->SetName(normals->GetName());
  turned->SetNumberOfComponents(3);
  turned->SetNumberOfTuples(normals->GetNumberOfTuples());
  for (vtkIdType i = 0; i < normals->GetNumberOfTuples(); ++i)
  {
    const double* const n = normals->GetTuple3(i);
    const Vec3 normal = place.normal({ n[0], n[1], n[2] });
    turned->SetTuple3(i, normal.x, normal.y, normal.z);
  }
  data.GetPointData()->SetNormals(turned);
}

InputModel converted(InputModel part, double millimetres)
{
  const double unit = bridge::unitOf(*part.data);
  if (isSameUnit(unit, millimetres))
  {
    return part;
  }
  const double scale = unit / millimetres;
  part = placed(std::move(part), { { scale, 0, 0 }, { 0, scale, 0 }, { 0, 0, scale }, {} });
  bridge::setUnit(*part.data, millimetres);
  part.note =
    part.name + " is converted from " + nameOfUnit(unit) + " to " + nameOfUnit(millimetres);
  return part;
}

/// Gives the parts without the array, which others have, one of the same value for all points.
template <class Array>
void complete(
  std::vector<InputModel>& parts, const char* name, int attribute, typename Array::ValueType value)
{
  const auto has = [&](const InputModel& part)
  { return part.data->GetPointData()->GetArray(name) != nullptr; };
  if (std::ranges::none_of(parts, has))
  {
    return;
  }
  for (InputModel& part : parts)
  {
    if (!has(part))
    {
      vtkNew<Array> array;
      array->SetName(name);
      array->SetNumberOfComponents(3);
      array->SetNumberOfTuples(part.data->GetNumberOfPoints());
      array->FillValue(value);
      part.data = copyOf(*part.data);
      part.data->GetPointData()->SetActiveAttribute(
        part.data->GetPointData()->AddArray(array), attribute);
    }
  }
}

/// The name of a file and the scan-point id behind its last point.
using PartEnd = std::pair<std::string, vtkIdType>;

void nameParts(vtkPolyData& merged, const std::vector<PartEnd>& parts)
{
  vtkNew<vtkStringArray> names;
  vtkNew<vtkIdTypeArray> ends;
  names->SetName(arrays::kScanFileNames);
  ends->SetName(arrays::kScanFileEnds);
  for (const auto& [name, end] : parts)
  {
    names->InsertNextValue(std::filesystem::path(name).filename().string());
    ends->InsertNextValue(end);
  }
  merged.GetFieldData()->AddArray(names);
  merged.GetFieldData()->AddArray(ends);
}

} // namespace

TransformList::TransformList(const std::string& path)
  : Path(path)
{
  const MappedFile file(path);
  this->Transforms = parseTransforms(file.bytes(), file.name());
}

const Affine& TransformList::placeOf(const std::string& file) const
{
  const ScanTransform* const found = findTransform(this->Transforms, file);
  if (found == nullptr)
  {
    throw Error(ErrorCode::badInput,
      this->Path + ": there is no transform for '" + file + "'; add a line, the identity is: \"" +
        file + "\" 0 0 0 0 0 0 1");
  }
  return found->place;
}

InputModel withUnit(InputModel model, double millimetres)
{
  const double known = bridge::unitOf(*model.data);
  if (known == 0.0)
  {
    model.data = copyOf(*model.data);
    bridge::setUnit(*model.data, millimetres);
  }
  else if (!isSameUnit(known, millimetres))
  {
    model.note = "says itself that its unit is " + nameOfUnit(known);
  }
  return model;
}

InputModel placed(InputModel model, const Affine& place)
{
  model.data = copyOf(*model.data);
  setPoints(*model.data, [&](const Vec3& point) { return place.point(point); });
  turnNormals(*model.data, place);
  if (place.isMirror())
  {
    vtkNew<vtkReverseSense> turn;
    turn->SetInputData(model.data);
    turn->Update();
    model.data = turn->GetOutput();
  }
  return model;
}

InputModel mergeModels(const std::vector<InputModel>& parts)
{
  if (parts.size() == 1)
  {
    return parts.front();
  }
  const double unit = bridge::unitOf(*parts.front().data);
  std::vector<InputModel> fitting;
  std::string note;
  for (const InputModel& part : parts)
  {
    if ((bridge::unitOf(*part.data) == 0.0) != (unit == 0.0))
    {
      throw Error(ErrorCode::badInput,
        "only some of the files say what their unit is; give that of the others with --unit");
    }
    fitting.push_back(converted(part, unit));
    if (!isSameUnit(bridge::unitOf(*part.data), unit))
    {
      addToNote(note, fitting.back().note);
    }
  }
  complete<vtkUnsignedCharArray>(fitting, arrays::kColors, vtkDataSetAttributes::SCALARS, 255);
  complete<vtkDoubleArray>(fitting, arrays::kNormals, vtkDataSetAttributes::NORMALS, 0.0);
  vtkNew<vtkAppendPolyData> append;
  append->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  for (const InputModel& part : fitting)
  {
    append->AddInputData(part.data);
  }
  append->Update();
  const vtkSmartPointer<vtkPolyData> merged = append->GetOutput();
  if (unit != 0.0)
  {
    bridge::setUnit(*merged, unit);
  }
  std::vector<PartEnd> ends;
  ends.reserve(parts.size());
  vtkIdType end = 0;
  for (const InputModel& part : parts)
  {
    ends.emplace_back(part.name, end += part.data->GetNumberOfPoints());
  }
  nameParts(*merged, ends);
  return { merged, parts.front().name, note };
}

InputModel appendModel(const InputModel& model, InputModel part)
{
  std::vector<vtkIdType> ids = bridge::scanPointIdsOf(*model.data);
  vtkIdType next = ids.empty() ? 0 : *std::ranges::max_element(ids) + 1;
  std::vector<PartEnd> ends;
  const std::vector<bridge::ScanFile> files = bridge::scanFilesOf(*model.data);
  for (std::size_t i = 0; i < files.size(); ++i)
  {
    vtkDataArray* const known = model.data->GetFieldData()->GetArray(arrays::kScanFileEnds);
    ends.emplace_back(
      files[i].name, static_cast<vtkIdType>(known->GetTuple1(static_cast<vtkIdType>(i))));
  }
  if (ends.empty() || next > ends.back().second)
  {
    ends.emplace_back(ends.empty() ? "model" : "added points", next);
  }
  next = ends.back().second; // which may be behind points that were removed

  const double unit = bridge::unitOf(*model.data);
  if (unit > 0.0 && bridge::unitOf(*part.data) == 0.0)
  {
    part = withUnit(std::move(part), unit);
  }
  InputModel merged = mergeModels({ model, part });
  for (vtkIdType i = 0; i < part.data->GetNumberOfPoints(); ++i)
  {
    ids.push_back(next++);
  }
  ends.emplace_back(part.name, next);
  bridge::setScanPointIds(*merged.data, ids);
  nameParts(*merged.data, ends);
  return merged;
}

} // namespace scan
