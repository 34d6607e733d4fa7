// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/base/error.h"
#include "filters/base/note.h"
#include "filters/wrap/vtkScanFineTuneFilter.h"
#include "filters/wrap/vtkScanFlattenFilter.h"
#include "filters/wrap/vtkScanPullFilter.h"
#include "filters/wrap/vtkScanPushFilter.h"
#include "filters/wrap/vtkScanRemoveWebsFilter.h"
#include "filters/wrap/vtkScanRepairAnglesFilter.h"
#include "filters/wrap/vtkScanShootFilter.h"
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
  const auto add = [&](const std::string& text) { addToNote(note, text); };
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
    regionParameter(),
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
    filter->SetRegion(valueOf<std::string>(values, "region"));
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
    regionParameter(),
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
  filter.SetRegion(valueOf<std::string>(values, "region"));
}

void setBlocks(vtkScanBlockEditFilter& filter, const ParameterValues& values)
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
  const EditReport& edit = report.Edit;
  return {
    { "marks", count(report.Marks) },
    { "tetrahedra-change", count(edit.change.tetrahedra) },
    { "euler-change", count(edit.change.eulerCharacteristic()) },
    { "triangles-gone", sizeOf(edit.surface.gone.size()) },
    { "triangles-new", sizeOf(edit.surface.added.size()) },
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
  const SurfaceChange& change = as<vtkScanWrapEditFilter>(algorithm).GetReport().Edit.surface;
  return change.gone.empty() && change.added.empty() ? "nothing changed" : std::string();
}

/// A row of the wrap stage: an edit with its own parameters and results beside the common ones.
template <class Filter>
Operation editOperation(std::string verb, std::string help, std::string example,
  const std::vector<Parameter>& parameters, void (*set)(Filter&, const ParameterValues&),
  Results (*found)(const Filter&))
{
  Operation row;
  row.verb = std::move(verb);
  row.stage = Stage::wrap;
  row.help = std::move(help);
  row.example = std::move(example);
  row.parameters = with(with(markParameters(), parameters), { kPreview, kManifold });
  row.make = [set](const ParameterValues& values) -> vtkSmartPointer<vtkAlgorithm>
  {
    const auto filter = vtkSmartPointer<Filter>::New();
    setMarks(*filter, values);
    filter->SetPreview(valueOf<bool>(values, "preview"));
    filter->SetManifold(valueOf<bool>(values, "manifold"));
    set(*filter, values);
    return filter;
  };
  row.results = [found](vtkAlgorithm& algorithm) -> Results
  {
    const auto& filter = as<Filter>(algorithm);
    Results results = editResults(filter);
    const Results own = found(filter);
    results.insert(results.begin() + 1, own.begin(), own.end());
    return results;
  };
  row.note = editNote;
  return row;
}

Operation pushOperation()
{
  return editOperation<vtkScanPushFilter>(
    "push", "Push the surface in: remove the blocks behind the marks",
    "scanwrap plate.xyz wrap --mode=classic push --at=0,0,0 --deep -o plate.stl", kBlockParameters,
    [](vtkScanPushFilter& filter, const ParameterValues& values) { setBlocks(filter, values); },
    [](const vtkScanPushFilter& filter) -> Results
    {
      const PushReport& pushed = filter.GetPushReport();
      return { { "blocks-removed", sizeOf(pushed.blocks.size()) },
        { "doors-removed", count(pushed.doors) }, { "blocks", numbersOf(pushed.blocks) } };
    });
}

Operation pullOperation()
{
  return editOperation<vtkScanPullFilter>(
    "pull", "Pull the surface out again: fill removed blocks",
    "scanwrap plate.xyz wrap --mode=classic push --at=0,0,0 pull --at=0,0,0 -o plate.stl",
    kBlockParameters,
    [](vtkScanPullFilter& filter, const ParameterValues& values) { setBlocks(filter, values); },
    [](const vtkScanPullFilter& filter) -> Results
    {
      const PushReport& pulled = filter.GetPushReport();
      return { { "blocks-added", sizeOf(pulled.blocks.size()) },
        { "blocks", numbersOf(pulled.blocks) } };
    });
}

Operation shootOperation()
{
  return editOperation<vtkScanShootFilter>(
    "shoot", "Shoot through the model: push every block on the way",
    "scanwrap pipe.xyz wrap --mode=classic shoot --at=0,0,5 --along=0,0,-1 -o pipe.stl",
    { { .name = "along",
      .defaultValue = PointList(),
      .help = "the way as dx,dy,dz; straight into the model where it is not given" } },
    [](vtkScanShootFilter& filter, const ParameterValues& values)
    {
      const auto& along = valueOf<PointList>(values, "along");
      if (along.size() > 1)
      {
        throw Error(ErrorCode::badParameter, "--along: one way is enough; shoot once more");
      }
      for (const Vec3& way : along)
      {
        filter.SetDirection(way.x, way.y, way.z);
      }
    },
    [](const vtkScanShootFilter& filter) -> Results
    {
      return { { "blocks-removed", sizeOf(filter.GetBlocks().size()) },
        { "blocks", numbersOf(filter.GetBlocks()) } };
    });
}

Operation fineTuneOperation()
{
  return editOperation<vtkScanFineTuneFilter>(
    "fine-tune", "Remove or fill single tetrahedra at the marks",
    "scanwrap scan.xyz wrap fine-tune --at=1,2,3 --fill -o part.stl",
    { { .name = "fill",
      .defaultValue = false,
      .help = "add the tetrahedron in front instead of removing the one behind" } },
    [](vtkScanFineTuneFilter& filter, const ParameterValues& values)
    { filter.SetFill(valueOf<bool>(values, "fill")); },
    [](const vtkScanFineTuneFilter&) { return Results(); });
}

Operation removeWebsOperation()
{
  return editOperation<vtkScanRemoveWebsFilter>(
    "remove-webs", "Remove sheets that span what was not scanned or hang over",
    "scanwrap scan.xyz wrap --mode=classic remove-webs -o part.stl",
    { { .name = "factor",
      .defaultValue = 4.0,
      .help = "a triangle is sparse when its circumradius exceeds so many local spacings",
      .minimum = 0 } },
    [](vtkScanRemoveWebsFilter& filter, const ParameterValues& values)
    { filter.SetFactor(valueOf<double>(values, "factor")); },
    [](const vtkScanRemoveWebsFilter& filter) -> Results
    {
      const WebReport& webs = filter.GetWebReport();
      return { { "sparse-triangles", count(webs.sparse) },
        { "hanging-triangles", count(webs.hanging) } };
    });
}

Operation flattenOperation()
{
  return editOperation<vtkScanFlattenFilter>(
    "flatten", "Make sheets of parts without thickness",
    "scanwrap sheet.xyz wrap --mode=classic flatten -o sheet.stl", {},
    [](vtkScanFlattenFilter&, const ParameterValues&) {},
    [](const vtkScanFlattenFilter& filter) -> Results {
      return { { "parts-flattened", count(filter.GetParts()) } };
    });
}

Operation repairAnglesOperation()
{
  return editOperation<vtkScanRepairAnglesFilter>(
    "repair-angles", "Repair bites along edges and rims",
    "scanwrap plate.xyz wrap repair-angles -o plate.stl",
    { { .name = "feature-angle",
      .defaultValue = 30.0,
      .help = "degrees by which the surface turns at an edge or rim, at least",
      .minimum = 0,
      .maximum = 179 } },
    [](vtkScanRepairAnglesFilter& filter, const ParameterValues& values)
    { filter.SetFeatureAngle(valueOf<double>(values, "feature-angle")); },
    [](const vtkScanRepairAnglesFilter& filter) -> Results
    {
      const AngleRepairReport& repairs = filter.GetRepairReport();
      return { { "repairs", count(repairs.repairs) }, { "flips", count(repairs.flips) } };
    });
}

} // namespace

std::vector<Operation> wrapOperations()
{
  return { wrapOperation(), pushOperation(), pullOperation(), shootOperation(), fineTuneOperation(),
    removeWebsOperation(), flattenOperation(), repairAnglesOperation() };
}

} // namespace scan
