// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/wrap/vtkScanWrapFilter.h"

#include "filters/base/vtkScanMeshBridge.h"
#include "filters/geometry/model_length.h"
#include "filters/wrap/vtkScanWrapData.h"

#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include <vector>

vtkStandardNewMacro(vtkScanWrapFilter);

void vtkScanWrapFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Mode: "
     << (this->Mode == CLASSIC    ? "classic"
            : this->Mode == FRONT ? "front"
                                  : "automatic")
     << "\n";
  os << indent << "Open: "
     << (this->Open == KEEP     ? "keep"
            : this->Open == CAP ? "cap"
                                : "decide")
     << "\n";
  os << indent << "Fit: " << (this->Fit == ROBUST ? "robust" : "all") << "\n";
  os << indent << "PrepareEdits: " << (this->PrepareEdits ? "true" : "false") << "\n";
  os << indent << "Manifold: " << (this->Manifold ? "true" : "false") << "\n";
}

vtkSmartPointer<vtkPolyData> vtkScanWrapFilter::NewOutput(vtkPolyData*)
{
  return vtkSmartPointer<vtkScanWrapData>::New();
}

void vtkScanWrapFilter::Run(vtkPolyData& input, vtkPolyData& output, scan::Execution& execution)
{
  using Options = scan::WrapOptions;
  Options options;
  options.mode = this->Mode == CLASSIC ? Options::Mode::classic
    : this->Mode == FRONT              ? Options::Mode::front
                                       : Options::Mode::automatic;
  options.opening = this->Open == KEEP ? scan::Opening::keep
    : this->Open == CAP                ? scan::Opening::cap
                                       : scan::Opening::automatic;
  options.fit = this->Fit == ROBUST ? Options::Fit::robust : Options::Fit::all;
  options.manifold = this->Manifold;

  auto* const earlier = vtkScanWrapData::SafeDownCast(&input);
  auto scan = earlier != nullptr ? earlier->GetModel().scan : nullptr;
  std::vector<scan::Vec3> points;
  vtkScanWrapData::PointIds ids;
  if (scan)
  {
    ids = earlier->GetInputIds();
  }
  else
  {
    points = scan::bridge::pointsOf(input);
    ids = std::make_shared<const std::vector<vtkIdType>>(scan::bridge::scanPointIdsOf(input));
  }
  if (this->Size.value() > 0.0)
  {
    options.size = inModelUnits(
      this->Size, scan ? scan->delaunay().points : points, scan::bridge::unitOf(input));
  }
  const bool withBlocks = options.mode == Options::Mode::classic;
  std::vector<scan::Phase> phases = scan::wrapPhases(options);
  if (withBlocks && this->Size.value() <= 0.0) // else it is one of them
  {
    phases.push_back({ "blocks", 1.0 });
  }
  if (withBlocks && this->PrepareEdits)
  {
    phases.push_back({ "holders", 2.0 });
  }
  execution.plan(phases);

  scan::WrapResult result =
    scan ? scan::wrap(scan, options, execution) : scan::wrap(points, options, execution);
  this->Report = result.report;
  const std::shared_ptr<const scan::ScanComplex> wrapped = result.model.scan;
  vtkScanWrapData::SafeDownCast(&output)->SetWrap(
    std::move(result), std::move(ids), withBlocks, execution);
  if (withBlocks && this->PrepareEdits)
  {
    wrapped->prepareEdits(execution);
  }
}
