// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/analysis/vtkScanInfoFilter.h"

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
  const scan::TriMesh mesh = scan::bridge::meshOf(input);
  this->Report = scan::describeMesh(mesh);
  execution.step("measure", 1, 2);
  this->Spacing = scan::meanSpacing(mesh.points);
  this->MillimetresPerUnit = scan::bridge::unitOf(input);
  this->Curves = input.GetNumberOfLines();
  this->Files = scan::bridge::scanFilesOf(input);
  output.ShallowCopy(&input);
  execution.step("measure", 2, 2);
}
