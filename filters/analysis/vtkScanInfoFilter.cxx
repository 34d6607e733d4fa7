// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/analysis/vtkScanInfoFilter.h"

#include "filters/base/vtkScanMeshBridge.h"

#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

vtkStandardNewMacro(vtkScanInfoFilter);

void vtkScanInfoFilter::Run(vtkPolyData& input, vtkPolyData& output, scan::Execution& execution)
{
  execution.plan({ { "measure", 1.0 } });
  execution.step("measure", 0, 1);
  this->Report = scan::describeMesh(scan::bridge::meshOf(input));
  output.ShallowCopy(&input);
  execution.step("measure", 1, 1);
}
