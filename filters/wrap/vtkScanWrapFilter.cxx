// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/wrap/vtkScanWrapFilter.h"

#include "filters/base/vtkScanMeshBridge.h"

#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include <vector>

vtkStandardNewMacro(vtkScanWrapFilter);

void vtkScanWrapFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Mode: " << (this->Mode == CLASSIC ? "classic" : "automatic") << "\n";
  os << indent << "Fit: " << (this->Fit == ROBUST ? "robust" : "all") << "\n";
  os << indent << "Manifold: " << (this->Manifold ? "true" : "false") << "\n";
}

void vtkScanWrapFilter::Run(vtkPolyData& input, vtkPolyData& output, scan::Execution& execution)
{
  using Options = scan::WrapOptions;
  Options options;
  options.mode = this->Mode == CLASSIC ? Options::Mode::classic : Options::Mode::automatic;
  options.fit = this->Fit == ROBUST ? Options::Fit::robust : Options::Fit::all;
  options.manifold = this->Manifold;
  execution.plan(scan::wrapPhases(options));

  const std::vector<scan::Vec3> points = scan::bridge::pointsOf(input);
  const scan::WrapResult result = scan::wrap(points, options, execution);
  this->Report = result.report;

  scan::bridge::setMesh(output, result.surface, result.lines);
  const std::vector<vtkIdType> inputIds = scan::bridge::scanPointIdsOf(input);
  std::vector<vtkIdType> ids;
  ids.reserve(result.scanPointIds.size());
  for (const scan::Index id : result.scanPointIds)
  {
    ids.push_back(inputIds[id]);
  }
  scan::bridge::setScanPointIds(output, ids);
}
