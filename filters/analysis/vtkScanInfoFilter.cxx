// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/analysis/vtkScanInfoFilter.h"

#include "filters/base/vtkScanRegions.h"
#include "filters/geometry/spacing.h"

#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

vtkStandardNewMacro(vtkScanInfoFilter);

vtkSmartPointer<vtkPolyData> vtkScanInfoFilter::NewOutput(vtkPolyData* input)
{
  return input != nullptr ? vtk::TakeSmartPointer(input->NewInstance())
                          : this->Superclass::NewOutput(input);
}

void vtkScanInfoFilter::Run(vtkPolyData& input, vtkPolyData& output, scan::Execution& execution)
{
  execution.plan({ { "measure", 1.0 } });
  execution.step("measure", 0, 2);
  const auto measured = scan::bridge::partOf(input, this->GetRegion(), execution);
  const scan::TriMesh mesh = scan::bridge::meshOf(*measured);
  this->Report = scan::describeMesh(mesh);
  execution.step("measure", 1, 2);
  this->Spacing = scan::meanSpacing(mesh.points);
  this->MillimetresPerUnit = scan::bridge::unitOf(*measured);
  this->Curves = measured->GetNumberOfLines();
  this->Files = scan::bridge::scanFilesOf(*measured);
  output.ShallowCopy(&input);
  execution.step("measure", 2, 2);
}
