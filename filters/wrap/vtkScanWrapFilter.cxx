// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/wrap/vtkScanWrapFilter.h"

#include "filters/base/vtkScanMeshBridge.h"
#include "filters/geometry/model_length.h"
#include "filters/wrap/vtkScanWrapData.h"

#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <numeric>
#include <vector>

vtkStandardNewMacro(vtkScanWrapFilter);

namespace
{

/// The points that were wrapped, in their order.
vtkSmartPointer<vtkPolyData> scanOf(vtkScanWrapData& wrap)
{
  const scan::DelaunayComplex& complex = wrap.GetModel().scan->delaunay();
  std::vector<scan::Index> order(complex.points.size());
  std::iota(order.begin(), order.end(), scan::Index{ 0 });
  std::ranges::sort(order, {}, [&](scan::Index vertex) { return complex.scanPoint[vertex]; });
  scan::TriMesh mesh;
  std::vector<vtkIdType> ids;
  for (const scan::Index vertex : order)
  {
    mesh.points.push_back(complex.points[vertex]);
    ids.push_back((*wrap.GetInputIds())[complex.scanPoint[vertex]]);
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  scan::bridge::setMesh(*data, mesh);
  scan::bridge::setScanPointIds(*data, ids);
  scan::bridge::passOrigin(wrap, *data);
  return data;
}

} // namespace

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

vtkSmartPointer<vtkPolyData> vtkScanWrapFilter::ChoosePoints(
  vtkPolyData& scan, scan::Execution& execution) const
{
  vtkSmartPointer<vtkPolyData> chosen = &scan;
  if (!this->GetRegion().empty())
  {
    chosen = vtkSmartPointer<vtkPolyData>::New();
    scan::bridge::keepPoints(scan, this->PointsInRegion(scan, execution), *chosen);
  }
  return chosen;
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
  if (scan && this->GetRegion().empty())
  {
    ids = earlier->GetInputIds();
  }
  else
  {
    const auto chosen = this->ChoosePoints(scan ? *scanOf(*earlier) : input, execution);
    points = scan::bridge::pointsOf(*chosen);
    ids = std::make_shared<const std::vector<vtkIdType>>(scan::bridge::scanPointIdsOf(*chosen));
    scan = nullptr;
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
