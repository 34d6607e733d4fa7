// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/wrap/vtkScanWrapEditFilter.h"

#include "filters/base/error.h"
#include "filters/base/vtkScanMeshBridge.h"
#include "filters/geometry/facet_search.h"
#include "filters/geometry/model_length.h"

#include <string>

vtkSmartPointer<vtkPolyData> vtkScanWrapEditFilter::NewOutput(vtkPolyData*)
{
  return vtkSmartPointer<vtkScanWrapData>::New();
}

void vtkScanWrapEditFilter::Run(vtkPolyData& input, vtkPolyData& output, scan::Execution& execution)
{
  vtkScanWrapData& wrap = vtkScanWrapData::Of(input);
  execution.plan({ { "marks", 1.0 }, { "blocks", 2.0 }, { "holders", 2.0 }, { "edit", 1.0 },
    { "surface", 4.0 } });
  execution.step("marks", 0, 1);
  this->Report = {};
  scan::WrapModel model = wrap.GetModel();
  this->Edit(wrap, model, this->Report, execution);
  execution.step("edit", 1, 1);
  scan::WrapResult result = surfaceOf(model, this->Manifold, execution);
  this->Report.Before = wrap.GetReport();
  this->Report.After = result.report;
  if (this->Preview)
  {
    output.ShallowCopy(&input);
    return;
  }
  vtkScanWrapData::SafeDownCast(&output)->SetWrap(
    std::move(result), wrap.GetInputIds(), true, execution);
}

std::vector<scan::Facet> vtkScanWrapEditFilter::FindTriangles(
  vtkScanWrapData& wrap, scan::Execution& execution) const
{
  const std::vector<scan::Facet>& facets = wrap.GetFacets();
  std::vector<scan::Facet> found;
  for (const vtkIdType triangle : this->Triangles)
  {
    if (triangle < 0 || triangle >= static_cast<vtkIdType>(facets.size()))
    {
      throw scan::Error(scan::ErrorCode::badParameter,
        "there is no triangle " + std::to_string(triangle) + "; the surface has " +
          std::to_string(facets.size()) + ", counted from 0");
    }
    found.push_back(facets[static_cast<std::size_t>(triangle)]);
  }
  if (!this->GetRegion().empty())
  {
    const std::vector<std::uint8_t> isInside = this->TrianglesInRegion(wrap, execution);
    for (std::size_t t = 0; t < facets.size(); ++t)
    {
      if (isInside[t] != 0)
      {
        found.push_back(facets[t]);
      }
    }
  }
  return found;
}

std::vector<scan::Facet> vtkScanWrapEditFilter::FindMarks(
  vtkScanWrapData& wrap, scan::Execution& execution) const
{
  const std::vector<scan::Facet>& facets = wrap.GetFacets();
  const scan::DelaunayComplex& complex = wrap.GetModel().scan->delaunay();
  const double within = inModelUnits(this->Within, complex.points, scan::bridge::unitOf(wrap));
  std::vector<scan::Facet> marks = this->FindTriangles(wrap, execution);
  for (const scan::Vec3& point : this->Points)
  {
    if (within > 0.0)
    {
      const auto near = facetsWithin(complex, facets, point, within, execution);
      marks.insert(marks.end(), near.begin(), near.end());
    }
    else if (!facets.empty())
    {
      marks.push_back(
        facetTowards(complex, nearestFacet(complex, facets, point, execution), point));
    }
  }
  return marks;
}
