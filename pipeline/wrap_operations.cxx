// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/wrap/vtkScanPullFilter.h"
#include "filters/wrap/vtkScanPushFilter.h"
#include "filters/wrap/vtkScanWrapFilter.h"
#include "pipeline/operation_rows.h"

#include <string>

namespace scan
{

namespace
{

const Parameter kManifold{ .name = "manifold",
  .defaultValue = true,
  .help = "split non-manifold edges and points into separate sheets" };

/// In the order of vtkScanWrapFilter::ModeType and OpenType.
const std::vector<std::string> kModes{ "auto", "classic", "front" };
const std::vector<std::string> kOpenings{ "auto", "keep", "cap" };

/// What a user who looks at the surface only would not see.
std::string wrapNote(vtkAlgorithm& filter)
{
  const WrapReport& report = as<vtkScanWrapFilter>(filter).GetReport();
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
  if (report.isOpen)
  {
    add("the scan is open and so is the surface; --open=cap closes it");
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
      .help = "auto: the finished surface; classic: the first hull, the start for pushing by hand; "
              "front: an advancing front, for comparison",
      .choices = kModes },
    { .name = "fit",
      .defaultValue = "all",
      .help = "all: through every point possible; robust: smoother on noisy scans",
      .choices = { "all", "robust" } },
    { .name = "open",
      .defaultValue = "auto",
      .help = "openings of the scan: auto decides; keep leaves them open, cap closes everything",
      .choices = kOpenings },
    { .name = "size",
      .defaultValue = Length(),
      .help = "classic mode: open what is reached through doors wider than this radius; 0: nothing",
      .minimum = 0 },
    kManifold,
  };
  row.make = [](const ParameterValues& values) -> vtkSmartPointer<vtkAlgorithm>
  {
    const auto filter = vtkSmartPointer<vtkScanWrapFilter>::New();
    filter->SetMode(static_cast<vtkScanWrapFilter::ModeType>(choiceOf(values, "mode", kModes)));
    filter->SetOpen(static_cast<vtkScanWrapFilter::OpenType>(choiceOf(values, "open", kOpenings)));
    filter->SetFit(valueOf<std::string>(values, "fit") == "robust" ? vtkScanWrapFilter::ROBUST
                                                                   : vtkScanWrapFilter::ALL);
    filter->SetSize(valueOf<Length>(values, "size"));
    filter->SetManifold(valueOf<bool>(values, "manifold"));
    return filter;
  };
  row.results = [](vtkAlgorithm& filter) -> Results
  {
    const WrapReport& report = as<vtkScanWrapFilter>(filter).GetReport();
    return {
      { "points-read", count(report.pointsRead) },
      { "duplicates-merged", count(report.duplicatesMerged) },
      { "points-on-surface", count(report.pointsOnSurface) },
      { "tetrahedra", count(report.tetrahedra) },
      { "tetrahedra-kept", count(report.tetrahedraKept) },
      { "boundary-triangles", count(report.boundaryTriangles) },
      { "sheet-triangles", count(report.sheetTriangles) },
      { "open", report.isOpen },
      { "opening-triangles", count(report.openingTriangles) },
      { "edges-split", count(report.nonManifoldEdges) },
      { "points-split", count(report.nonManifoldVertices) },
    };
  };
  row.note = wrapNote;
  return row;
}

/// Where an edit applies.
std::vector<Parameter> markParameters()
{
  return {
    { .name = "at",
      .defaultValue = PointList(),
      .help = "at the triangle nearest to this point, or these; may be repeated" },
    { .name = "triangle",
      .defaultValue = IdList(),
      .help = "at this triangle of the surface, or these, counted from 0" },
    { .name = "within",
      .defaultValue = Length(),
      .help = "at all triangles that come this near to the points; 0: the nearest one",
      .minimum = 0 },
  };
}

std::vector<Parameter> with(std::vector<Parameter> first, const std::vector<Parameter>& more)
{
  first.insert(first.end(), more.begin(), more.end());
  return first;
}

const Parameter kPreview{
  .name = "preview", .defaultValue = false, .help = "only say what would change"
};

const std::vector<Parameter> kBlockParameters{
  { .name = "block",
    .defaultValue = IdList(),
    .help = "this block, or these, by the numbers in the array Block" },
  { .name = "deep",
    .defaultValue = false,
    .help = "and on, to every block that one passes to through wide doors" },
  { .name = "reach",
    .defaultValue = 1.5,
    .help = "a door is wide when this many times its radius is at least the size of the block",
    .minimum = 1 },
};

void setMarks(vtkScanWrapEditFilter& filter, const ParameterValues& values)
{
  for (const Vec3& p : valueOf<PointList>(values, "at"))
  {
    filter.AddPoint(p.x, p.y, p.z);
  }
  for (const std::int64_t triangle : valueOf<IdList>(values, "triangle"))
  {
    filter.AddTriangle(triangle);
  }
  filter.SetWithin(valueOf<Length>(values, "within"));
}

void setCommon(vtkScanWrapEditFilter& filter, const ParameterValues& values)
{
  filter.SetPreview(valueOf<bool>(values, "preview"));
  filter.SetManifold(valueOf<bool>(values, "manifold"));
}

template <class Filter>
void setBlocks(Filter& filter, const ParameterValues& values)
{
  filter.SetDeep(valueOf<bool>(values, "deep"));
  filter.SetReach(valueOf<double>(values, "reach"));
  for (const std::int64_t block : valueOf<IdList>(values, "block"))
  {
    filter.AddBlock(block);
  }
}

/// What every edit tells.
Results editResults(const vtkScanWrapEditFilter& filter)
{
  const vtkScanWrapEditReport& report = filter.GetReport();
  return {
    { "marks", count(report.Marks) },
    { "tetrahedra-change", count(report.Change.tetrahedra) },
    { "euler-change", count(report.Change.eulerCharacteristic()) },
    { "triangles-gone", count(static_cast<std::int64_t>(report.Surface.gone.size())) },
    { "triangles-new", count(static_cast<std::int64_t>(report.Surface.added.size())) },
    { "points-before", count(report.Before.pointsOnSurface) },
    { "points-on-surface", count(report.After.pointsOnSurface) },
    { "tetrahedra-kept", count(report.After.tetrahedraKept) },
    { "boundary-triangles", count(report.After.boundaryTriangles) },
    { "sheet-triangles", count(report.After.sheetTriangles) },
    { "edges-split", count(report.After.nonManifoldEdges) },
    { "points-split", count(report.After.nonManifoldVertices) },
  };
}

std::string numbersOf(const std::vector<BlockName>& blocks)
{
  constexpr std::size_t kMost = 1000; // of millions
  IdList numbers;
  for (std::size_t i = 0; i < std::min(kMost, blocks.size()); ++i)
  {
    numbers.push_back(numberOf(blocks[i]));
  }
  return textOf(numbers);
}

std::string editNote(vtkAlgorithm& algorithm)
{
  const auto& filter = as<vtkScanWrapEditFilter>(algorithm);
  const vtkScanWrapEditReport& report = filter.GetReport();
  const bool isSame = report.Surface.gone.empty() && report.Surface.added.empty();
  return isSame ? "nothing changed" : std::string();
}

Operation pushOperation()
{
  Operation row;
  row.verb = "push";
  row.stage = Stage::wrap;
  row.help = "Push the surface in: remove the blocks behind the marks";
  row.example = "scanwrap plate.xyz wrap --mode=classic push --at=0,0,0 --deep -o plate.stl";
  row.parameters = with(with(markParameters(), kBlockParameters), { kPreview, kManifold });
  row.make = [](const ParameterValues& values) -> vtkSmartPointer<vtkAlgorithm>
  {
    const auto filter = vtkSmartPointer<vtkScanPushFilter>::New();
    setMarks(*filter, values);
    setBlocks(*filter, values);
    setCommon(*filter, values);
    return filter;
  };
  row.results = [](vtkAlgorithm& algorithm) -> Results
  {
    const auto& filter = as<vtkScanPushFilter>(algorithm);
    Results results = editResults(filter);
    results.insert(results.begin() + 1,
      { { "blocks-removed", count(static_cast<std::int64_t>(filter.GetBlocks().size())) },
        { "doors-removed", count(filter.GetDoors()) },
        { "blocks", numbersOf(filter.GetBlocks()) } });
    return results;
  };
  row.note = editNote;
  return row;
}

Operation pullOperation()
{
  Operation row;
  row.verb = "pull";
  row.stage = Stage::wrap;
  row.help = "Pull the surface out again: fill removed blocks";
  row.example =
    "scanwrap plate.xyz wrap --mode=classic push --at=0,0,0 pull --at=0,0,0 -o plate.stl";
  row.parameters = with(with(markParameters(), kBlockParameters), { kPreview, kManifold });
  row.make = [](const ParameterValues& values) -> vtkSmartPointer<vtkAlgorithm>
  {
    const auto filter = vtkSmartPointer<vtkScanPullFilter>::New();
    setMarks(*filter, values);
    setBlocks(*filter, values);
    setCommon(*filter, values);
    return filter;
  };
  row.results = [](vtkAlgorithm& algorithm) -> Results
  {
    const auto& filter = as<vtkScanPullFilter>(algorithm);
    Results results = editResults(filter);
    results.insert(results.begin() + 1,
      { { "blocks-added", count(static_cast<std::int64_t>(filter.GetBlocks().size())) },
        { "blocks", numbersOf(filter.GetBlocks()) } });
    return results;
  };
  row.note = editNote;
  return row;
}

} // namespace

std::vector<Operation> wrapOperations()
{
  return { wrapOperation(), pushOperation(), pullOperation() };
}

} // namespace scan
