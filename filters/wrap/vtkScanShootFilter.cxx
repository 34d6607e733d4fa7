// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/wrap/vtkScanShootFilter.h"

#include "filters/geometry/pushes.h"
#include "filters/geometry/shoot.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkScanShootFilter);

void vtkScanShootFilter::Edit(vtkScanWrapData& wrap, scan::WrapModel& model,
  vtkScanWrapEditReport& report, scan::Execution& execution)
{
  const std::vector<scan::Facet> marks = this->FindMarks(wrap, execution);
  const scan::Vec3 given{ this->Direction[0], this->Direction[1], this->Direction[2] };
  std::vector<scan::BlockName> met;
  for (std::size_t i = 0; i < marks.size(); ++i)
  {
    // triangles come first, then one mark a point
    const std::size_t triangles = marks.size() - this->GetPoints().size();
    const scan::Triangle v = model.scan->delaunay().facetVertices(marks[i]);
    const std::vector<scan::Vec3>& points = model.scan->delaunay().points;
    const scan::Vec3 middle = (points[v[0]] + points[v[1]] + points[v[2]]) * (1.0 / 3.0);
    const scan::Vec3 inward = cross(points[v[2]] - points[v[0]], points[v[1]] - points[v[0]]);
    const std::vector<scan::BlockName> inSight =
      blocksInSight(model, marks[i], i < triangles ? middle : this->GetPoints()[i - triangles],
        given == scan::Vec3{} ? inward : given, execution);
    met.insert(met.end(), inSight.begin(), inSight.end());
  }
  report.Marks = static_cast<scan::Index>(marks.size());
  const scan::PushReport pushed = push(model, {}, met, {}, execution);
  this->Blocks = pushed.blocks;
  report.Edit = pushed;
}
