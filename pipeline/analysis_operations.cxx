// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/analysis/vtkScanInfoFilter.h"
#include "filters/analysis/vtkScanRenderFilter.h"
#include "filters/base/unit.h"
#include "pipeline/operation_rows.h"

#include <vtkAlgorithm.h>

#include <algorithm>
#include <optional>

namespace scan
{

namespace
{

ResultValue optionalCount(const std::optional<std::int64_t>& number)
{
  return number ? ResultValue(*number) : ResultValue();
}

ResultValue unitName(double millimetres)
{
  return millimetres > 0.0 ? ResultValue(nameOfUnit(millimetres)) : ResultValue();
}

/// In the order of vtkScanRenderFilter::ViewType.
const std::vector<std::string> kViews = viewNames({ "iso" });

Results infoResults(vtkAlgorithm& filter)
{
  const auto& info = as<vtkScanInfoFilter>(filter);
  const MeshReport& report = info.GetReport();
  Results results{
    { "points", count(report.points) },
    { "triangles", count(report.triangles) },
    { "curves", count(info.GetCurves()) },
    { "unit", unitName(info.GetMillimetresPerUnit()) },
    { "box-min-x", report.boxMin.x },
    { "box-min-y", report.boxMin.y },
    { "box-min-z", report.boxMin.z },
    { "box-max-x", report.boxMax.x },
    { "box-max-y", report.boxMax.y },
    { "box-max-z", report.boxMax.z },
    { "box-diagonal", report.boxDiagonal },
    { "spacing", info.GetSpacing() },
  };
  for (const auto& [name, points] : info.GetFiles())
  {
    results.emplace_back("points-of " + name, sizeOf(points));
  }
  if (report.components.empty())
  {
    return results;
  }
  const Results ofSurface{
    { "points-used", count(report.pointsUsed) },
    { "edges", count(report.edges) },
    { "components", sizeOf(report.components.size()) },
    { "largest-component-points", count(report.components.front().points) },
    { "largest-component-triangles", count(report.components.front().triangles) },
    { "closed", report.isClosed },
    { "manifold", report.isManifold },
    { "oriented", report.isOriented },
    { "euler-characteristic", count(report.eulerCharacteristic) },
    { "genus", optionalCount(report.genus) },
    { "boundary-edges", count(report.boundaryEdges) },
    { "boundary-loops", count(report.boundaryLoops) },
    { "non-manifold-edges", count(report.nonManifoldEdges) },
    { "non-manifold-points", count(report.nonManifoldVertices) },
    { "misoriented-edges", count(report.misorientedEdges) },
    { "collapsed-triangles", count(report.collapsedTriangles) },
    { "flat-triangles", count(report.flatTriangles) },
    { "area", report.area },
    { "volume", report.volume ? ResultValue(*report.volume) : ResultValue() },
    { "shortest-edge", report.shortestEdge },
    { "mean-edge", report.meanEdge },
    { "longest-edge", report.longestEdge },
  };
  results.insert(results.end(), ofSurface.begin(), ofSurface.end());
  return results;
}

Operation infoOperation()
{
  Operation row;
  row.verb = "info";
  row.stage = Stage::analysis;
  row.help = "Measure the model: counts, size, holes, components, area, volume";
  row.example = "scanwrap part.stl info --json=part.json";
  row.parameters = { regionParameter() };
  row.make = [](const ParameterValues& values) -> vtkSmartPointer<vtkAlgorithm>
  {
    const auto filter = vtkSmartPointer<vtkScanInfoFilter>::New();
    filter->SetRegion(valueOf<std::string>(values, "region"));
    return filter;
  };
  row.results = infoResults;
  return row;
}

Operation renderOperation()
{
  constexpr double kLeastPixels = 16;
  constexpr double kMostPixels = 4096;
  Operation row;
  row.verb = "render";
  row.stage = Stage::analysis;
  row.help = "Make a picture of the model, no display needed";
  row.example = "scanwrap part.stl render --view=front --edges -o part.png";
  row.parameters = {
    { .name = "width",
      .defaultValue = std::int64_t{ 1200 },
      .help = "pixels",
      .minimum = kLeastPixels,
      .maximum = kMostPixels },
    { .name = "height",
      .defaultValue = std::int64_t{ 900 },
      .help = "pixels",
      .minimum = kLeastPixels,
      .maximum = kMostPixels },
    { .name = "view",
      .defaultValue = "iso",
      .help = "the side to look at; iso is right, front and above at once",
      .choices = kViews },
    { .name = "up",
      .defaultValue = "z",
      .help = "the axis that points up",
      .choices = { "z", "y" } },
    regionParameter(),
    { .name = "perspective",
      .defaultValue = true,
      .help = "as through a lens, else a parallel projection" },
    { .name = "edges", .defaultValue = false, .help = "draw the edges of the triangles" },
    { .name = "color",
      .defaultValue = "",
      .help = "of the model: an HTML name or #rrggbb; empty for clay" },
    { .name = "background",
      .defaultValue = "",
      .help = "an HTML name or #rrggbb; empty for a light gradient" },
    { .name = "point-size",
      .defaultValue = 0.0,
      .help = "diameter of points in pixels; 0 makes points touch",
      .minimum = 0,
      .maximum = 100 },
  };
  row.make = [](const ParameterValues& values) -> vtkSmartPointer<vtkAlgorithm>
  {
    const auto filter = vtkSmartPointer<vtkScanRenderFilter>::New();
    filter->SetWidth(static_cast<int>(valueOf<std::int64_t>(values, "width")));
    filter->SetHeight(static_cast<int>(valueOf<std::int64_t>(values, "height")));
    filter->SetView(static_cast<vtkScanRenderFilter::ViewType>(choiceOf(values, "view", kViews)));
    filter->SetUp(valueOf<std::string>(values, "up") == "y" ? vtkScanRenderFilter::Y_UP
                                                            : vtkScanRenderFilter::Z_UP);
    filter->SetRegion(valueOf<std::string>(values, "region"));
    filter->SetPerspective(valueOf<bool>(values, "perspective"));
    filter->SetEdges(valueOf<bool>(values, "edges"));
    filter->SetColor(valueOf<std::string>(values, "color"));
    filter->SetBackground(valueOf<std::string>(values, "background"));
    filter->SetPointSize(valueOf<double>(values, "point-size"));
    return filter;
  };
  return row;
}

} // namespace

std::vector<Operation> analysisOperations()
{
  return { infoOperation(), renderOperation() };
}

} // namespace scan
