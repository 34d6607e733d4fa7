// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/operation_table.h"

#include "filters/analysis/vtkScanInfoFilter.h"
#include "filters/analysis/vtkScanRenderFilter.h"
#include "filters/base/error.h"
#include "filters/wrap/vtkScanWrapFilter.h"

#include <algorithm>
#include <array>
#include <optional>

namespace scan
{

namespace
{

template <class T>
const T& get(const ParameterValues& values, std::string_view name)
{
  return std::get<T>(values.find(name)->second);
}

ResultValue count(std::int64_t number)
{
  return number;
}

ResultValue optionalCount(const std::optional<std::int64_t>& number)
{
  return number ? ResultValue(*number) : ResultValue();
}

/// In the order of vtkScanRenderFilter::ViewType.
const std::vector<std::string> kViews{ "iso", "front", "back", "left", "right", "top", "bottom" };

/// What a user who looks at the surface only would not see.
std::string wrapNote(vtkAlgorithm& filter)
{
  const WrapReport& report = dynamic_cast<vtkScanWrapFilter&>(filter).GetReport();
  const Index distinct = report.pointsRead - report.duplicatesMerged;
  std::string note;
  const auto add = [&](const std::string& text) { note += (note.empty() ? "" : "; ") + text; };
  if (report.duplicatesMerged > 0)
  {
    add(std::to_string(report.duplicatesMerged) + " of " + std::to_string(report.pointsRead) +
      " points repeat others and were merged");
  }
  if (report.pointsOnSurface < distinct)
  {
    add(std::to_string(distinct - report.pointsOnSurface) + " of " + std::to_string(distinct) +
      " points are not on the surface");
  }
  if (report.nonManifoldEdges + report.nonManifoldVertices > 0)
  {
    add("the surface touched itself and was split at " + std::to_string(report.nonManifoldEdges) +
      " edges and " + std::to_string(report.nonManifoldVertices) + " points");
  }
  return note;
}

Operation wrapOperation()
{
  Operation row;
  row.verb = "wrap";
  row.stage = Stage::wrap;
  row.help = "Make a surface from the points, without normals or parameters";
  row.example = "scanwrap scan.xyz wrap -o part.stl";
  row.parameters = {
    { .name = "mode",
      .defaultValue = "auto",
      .help = "auto: the finished surface; classic: the first hull, the start for pushing by hand",
      .choices = { "auto", "classic" } },
    { .name = "fit",
      .defaultValue = "all",
      .help = "all: through every point possible; robust: smoother on noisy scans",
      .choices = { "all", "robust" } },
    { .name = "manifold",
      .defaultValue = true,
      .help = "split non-manifold edges and points into separate sheets" },
  };
  row.make = [](const ParameterValues& values) -> vtkSmartPointer<vtkAlgorithm>
  {
    const auto filter = vtkSmartPointer<vtkScanWrapFilter>::New();
    filter->SetMode(get<std::string>(values, "mode") == "classic" ? vtkScanWrapFilter::CLASSIC
                                                                  : vtkScanWrapFilter::AUTOMATIC);
    filter->SetFit(get<std::string>(values, "fit") == "robust" ? vtkScanWrapFilter::ROBUST
                                                               : vtkScanWrapFilter::ALL);
    filter->SetManifold(get<bool>(values, "manifold"));
    return filter;
  };
  row.results = [](vtkAlgorithm& filter) -> Results
  {
    const WrapReport& report = dynamic_cast<vtkScanWrapFilter&>(filter).GetReport();
    return {
      { "points-read", count(report.pointsRead) },
      { "duplicates-merged", count(report.duplicatesMerged) },
      { "points-on-surface", count(report.pointsOnSurface) },
      { "tetrahedra", count(report.tetrahedra) },
      { "tetrahedra-kept", count(report.tetrahedraKept) },
      { "boundary-triangles", count(report.boundaryTriangles) },
      { "sheet-triangles", count(report.sheetTriangles) },
      { "edges-split", count(report.nonManifoldEdges) },
      { "points-split", count(report.nonManifoldVertices) },
    };
  };
  row.note = wrapNote;
  return row;
}

Results infoResults(vtkAlgorithm& filter)
{
  const auto& info = dynamic_cast<vtkScanInfoFilter&>(filter);
  const MeshReport& report = info.GetReport();
  Results results{
    { "points", count(report.points) },
    { "triangles", count(report.triangles) },
    { "box-min-x", report.boxMin.x },
    { "box-min-y", report.boxMin.y },
    { "box-min-z", report.boxMin.z },
    { "box-max-x", report.boxMax.x },
    { "box-max-y", report.boxMax.y },
    { "box-max-z", report.boxMax.z },
    { "box-diagonal", report.boxDiagonal },
    { "spacing", info.GetSpacing() },
  };
  if (report.components.empty())
  {
    return results;
  }
  const Results ofSurface{
    { "points-used", count(report.pointsUsed) },
    { "edges", count(report.edges) },
    { "components", count(static_cast<std::int64_t>(report.components.size())) },
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
  row.make = [](const ParameterValues&) -> vtkSmartPointer<vtkAlgorithm>
  { return vtkSmartPointer<vtkScanInfoFilter>::New(); };
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
    const auto view = std::ranges::find(kViews, get<std::string>(values, "view")) - kViews.begin();
    filter->SetWidth(static_cast<int>(get<std::int64_t>(values, "width")));
    filter->SetHeight(static_cast<int>(get<std::int64_t>(values, "height")));
    filter->SetView(static_cast<vtkScanRenderFilter::ViewType>(view));
    filter->SetUp(get<std::string>(values, "up") == "y" ? vtkScanRenderFilter::Y_UP
                                                        : vtkScanRenderFilter::Z_UP);
    filter->SetPerspective(get<bool>(values, "perspective"));
    filter->SetEdges(get<bool>(values, "edges"));
    filter->SetColor(get<std::string>(values, "color"));
    filter->SetBackground(get<std::string>(values, "background"));
    filter->SetPointSize(get<double>(values, "point-size"));
    return filter;
  };
  return row;
}

} // namespace

std::string_view nameOf(Stage stage)
{
  static constexpr std::array<std::string_view, 6> kNames{ "input", "points", "wrap", "surface",
    "analysis", "output" };
  return kNames.at(static_cast<std::size_t>(stage));
}

const std::vector<Operation>& operationTable()
{
  static const std::vector<Operation> kTable{ wrapOperation(), infoOperation(), renderOperation() };
  return kTable;
}

const Operation* findOperation(std::string_view verb)
{
  const std::vector<Operation>& table = operationTable();
  const auto row = std::ranges::find(table, verb, &Operation::verb);
  return row != table.end() ? &*row : nullptr;
}

ParameterValues completeValues(const Operation& operation, const ParameterValues& given)
{
  ParameterValues values;
  for (const Parameter& parameter : operation.parameters)
  {
    values[parameter.name] = parameter.defaultValue;
  }
  for (const auto& [name, value] : given)
  {
    const auto parameter = std::ranges::find(operation.parameters, name, &Parameter::name);
    if (parameter == operation.parameters.end())
    {
      throw Error(ErrorCode::badParameter, operation.verb + ": there is no option --" + name);
    }
    checkValue(*parameter, value);
    values[name] = value;
  }
  return values;
}

} // namespace scan
