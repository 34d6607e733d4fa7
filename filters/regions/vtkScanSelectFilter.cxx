// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/regions/vtkScanSelectFilter.h"

#include "filters/base/vtkScanMeshBridge.h"
#include "filters/base/vtkScanRegions.h"

#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

vtkStandardNewMacro(vtkScanSelectFilter);

namespace
{

double shareOf(vtkIdType part, vtkIdType all)
{
  return all > 0 ? static_cast<double>(part) / static_cast<double>(all) : 0.0;
}

} // namespace

vtkSmartPointer<vtkPolyData> vtkScanSelectFilter::NewOutput(vtkPolyData* input)
{
  return input != nullptr ? vtk::TakeSmartPointer(input->NewInstance())
                          : this->Superclass::NewOutput(input);
}

void vtkScanSelectFilter::Run(vtkPolyData& input, vtkPolyData& output, scan::Execution& execution)
{
  execution.plan({ { "select", 1.0 } });
  execution.step("select", 0, 1);
  if (!scan::isRegionName(this->Name))
  {
    throw scan::Error(scan::ErrorCode::badParameter,
      "--name=" + this->Name +
        ": expected a name of letters, digits, - and _, a letter first, that is no function");
  }
  if (this->Rule.empty())
  {
    throw scan::Error(scan::ErrorCode::badParameter,
      "--rule: expected what belongs to the region, such as sphere(0,0,0,5)");
  }
  const scan::RegionRule rule = parseRegionRule(this->Rule, scan::bridge::regionsOf(input));
  this->StoredRule = textOf(rule);
  const auto part = scan::bridge::partOf(input, this->StoredRule, execution);
  this->Points = part->GetNumberOfPoints();
  this->Triangles = scan::bridge::triangleCountOf(*part);
  const vtkIdType all = scan::bridge::triangleCountOf(input);
  this->Share =
    all > 0 ? shareOf(this->Triangles, all) : shareOf(this->Points, input.GetNumberOfPoints());
  if (this->Points == 0)
  {
    this->AddNote("nothing is in the region " + this->Name);
  }
  output.ShallowCopy(&input);
  scan::bridge::setRegion(output, this->Name, rule);
  execution.step("select", 1, 1);
}
