// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/surface/vtkScanMendFilter.h"

#include "filters/base/vtkScanMeshBridge.h"
#include "filters/base/vtkScanRegions.h"

#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>

vtkStandardNewMacro(vtkScanMendFilter);

namespace
{

void setArray(
  vtkDataSetAttributes& data, const std::string& name, const std::vector<std::uint8_t>& values)
{
  vtkNew<vtkUnsignedCharArray> array;
  array->SetName(name.c_str());
  array->SetNumberOfValues(static_cast<vtkIdType>(values.size()));
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  data.AddArray(array);
}

std::string textOf(const scan::DefectList& list)
{
  std::string text;
  for (std::size_t kind = 0; kind < scan::kDefectKinds; ++kind)
  {
    if (const std::size_t count = list.count(static_cast<scan::DefectKind>(kind)); count > 0)
    {
      text.append(text.empty() ? "" : ", ").append(std::to_string(count)).append(" ");
      text.append(scan::kDefectNames.at(kind));
    }
  }
  return text;
}

using Marks = std::vector<std::uint8_t>;

/// Per triangle 1 where there is a defect of that kind.
Marks trianglesWith(
  std::size_t kind, const std::vector<scan::Defect>& defects, std::size_t triangles)
{
  Marks marks(triangles, 0);
  for (const scan::Defect& defect : defects)
  {
    for (const scan::Index t : defect.triangles)
    {
      if (static_cast<std::size_t>(defect.kind) == kind)
      {
        marks[t] = 1;
      }
    }
  }
  return marks;
}

/// Per point the mark of the first of its triangles that has one.
Marks atCorners(const scan::TriMesh& mesh, const Marks& marks)
{
  Marks onPoints(mesh.points.size(), 0);
  for (std::size_t t = 0; t < marks.size(); ++t)
  {
    for (const scan::Index point : mesh.triangles[t])
    {
      onPoints[point] = onPoints[point] == 0 ? marks[t] : onPoints[point];
    }
  }
  return onPoints;
}

} // namespace

std::vector<scan::Phase> vtkScanMendFilter::Phases() const
{
  return { { "find defects", 1.0 }, { "mend", 1.0 } };
}

scan::SurfaceEdit vtkScanMendFilter::Edit(const Surface& surface, scan::Execution& execution)
{
  scan::MendOptions options = this->Options;
  options.defects.leastHeight = InModelUnits(this->LeastHeight, surface);
  options.defects.smallHole = InModelUnits(this->SmallHole, surface);
  options.maxDeviation = surface.maxDeviation;
  const std::vector<std::uint8_t> inRegion = this->TrianglesInRegion(surface, execution);
  this->Result = scan::mend(surface.mesh, inRegion, options, execution);
  if (this->Mark)
  {
    this->Result.edit = scan::unchanged(surface.mesh);
  }
  if (const std::string left = textOf(this->Result.left); !left.empty())
  {
    this->AddNote((this->Mark ? "would leave " : "left ") + left);
  }
  return std::exchange(this->Result.edit, {});
}

void vtkScanMendFilter::Finish(vtkPolyData& output)
{
  if (!this->Mark)
  {
    return;
  }
  const scan::TriMesh mesh = scan::bridge::meshOf(output);
  const auto add = [&](const std::string& name, const Marks& marks)
  {
    setArray(*output.GetCellData(), name, marks);
    setArray(*output.GetPointData(), name, atCorners(mesh, marks));
  };
  Marks first(mesh.triangles.size(), 0);
  for (std::size_t kind = 0; kind < scan::kDefectKinds; ++kind)
  {
    const Marks marks = trianglesWith(kind, this->Result.found.defects, mesh.triangles.size());
    for (std::size_t t = 0; t < marks.size(); ++t)
    {
      first[t] = first[t] == 0 && marks[t] != 0 ? static_cast<std::uint8_t>(kind + 1) : first[t];
    }
    if (std::ranges::count(marks, 1) > 0)
    {
      const std::string kindName(scan::kDefectNames.at(kind));
      const std::string name = "Defect-" + kindName;
      add(name, marks);
      scan::RegionRule rule;
      rule.kind = scan::RegionRule::Kind::array;
      rule.array = name;
      rule.numbers = { 1.0, 1.0 };
      scan::bridge::setRegion(output, kindName, rule);
    }
  }
  add("Defect", first);
}
