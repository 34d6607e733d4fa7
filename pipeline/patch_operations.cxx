// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/base/error.h"
#include "filters/surface/vtkScanBridgeFilter.h"
#include "filters/surface/vtkScanFillHolesFilter.h"
#include "filters/surface/vtkScanRemeshFilter.h"
#include "pipeline/surface_rows.h"

#include <algorithm>

namespace scan
{

namespace
{

/// In the order of FillShape and OuterRims.
const std::vector<std::string> kFillShapes{ "flat", "tangent", "curved" };
const std::vector<std::string> kOuterRims{ "auto", "keep", "fill" };

} // namespace

Operation fillHolesOperation()
{
  Operation row;
  row.verb = "fill-holes";
  row.stage = Stage::surface;
  row.help = "Close holes of the surface; max-deviation is that from flat patches";
  row.example = "scanwrap scan.ply fill-holes --shape=curved --max-perimeter=20mm -o closed.stl";
  row.parameters = surfaceParameters({
    { .name = "shape",
      .defaultValue = "tangent",
      .help = "flat: no new points; tangent: as dense as the rim, its slopes go on; curved: its "
              "curvature, too",
      .choices = kFillShapes },
    { .name = "rims",
      .defaultValue = "auto",
      .help = "the longest rim of an open piece; auto: is left when a disk as long is larger than "
              "half the piece; keep: is left; fill: is a hole",
      .choices = kOuterRims },
    { .name = "max-perimeter",
      .defaultValue = Length(),
      .help = "holes with a longer rim are left; 0: none",
      .minimum = 0 },
    { .name = "max-edges",
      .defaultValue = std::int64_t{ 0 },
      .help = "holes with more edges are left; 0: none",
      .minimum = 0,
      .maximum = 999999 },
    { .name = "at",
      .defaultValue = PointList(),
      .help = "only the hole with the rim nearest to this place, or these; may be repeated" },
    { .name = "from",
      .defaultValue = PointList(),
      .help = "with --to: only the part of a hole between two places of its rim, the shorter way" },
    { .name = "to", .defaultValue = PointList(), .help = "with --from: the other place" },
  });
  row.make = [](const ParameterValues& values) -> vtkSmartPointer<vtkAlgorithm>
  {
    const auto filter = newSurfaceFilter<vtkScanFillHolesFilter>(values);
    filter->SetShape(static_cast<FillShape>(choiceOf(values, "shape", kFillShapes)));
    filter->SetOuterRims(static_cast<OuterRims>(choiceOf(values, "rims", kOuterRims)));
    filter->SetMaxPerimeter(valueOf<Length>(values, "max-perimeter"));
    filter->SetMaxEdges(static_cast<Index>(valueOf<std::int64_t>(values, "max-edges")));
    for (const Vec3& p : valueOf<PointList>(values, "at"))
    {
      filter->AddPlace(p.x, p.y, p.z);
    }
    const auto from = singlePoint(values, "from");
    const auto to = singlePoint(values, "to");
    if (from.has_value() != to.has_value())
    {
      throw Error(ErrorCode::badParameter, "--from and --to belong together");
    }
    if (from && to)
    {
      filter->SetPart({ *from, *to });
    }
    return filter;
  };
  row.results = [](vtkAlgorithm& algorithm) -> Results
  {
    const auto& filter = as<vtkScanFillHolesFilter>(algorithm);
    const FillHolesResult& result = filter.GetResult();
    const auto filled = std::ranges::count(result.holes, HoleFate::filled, &Hole::fate);
    return surfaceResults(filter,
      { { "holes", sizeOf(result.holes.size()) }, { "holes-filled", count(filled) },
        { "holes-left", count(static_cast<std::int64_t>(result.holes.size()) - filled) },
        { "points-added", count(result.pointsAdded) },
        { "triangles-added", count(result.trianglesAdded) } });
  };
  return row;
}

Operation bridgeOperation()
{
  Operation row;
  row.verb = "bridge";
  row.stage = Stage::surface;
  row.help = "Join two rims, or two places of one, by a strip of triangles";
  row.example = "scanwrap scan.ply bridge --from=0,0,1 --to=0,0,3 --width=4 fill-holes -o part.stl";
  row.parameters = surfaceParameters({
    { .name = "from", .defaultValue = PointList(), .help = "near the rim where it begins" },
    { .name = "to", .defaultValue = PointList(), .help = "near the rim where it ends" },
    { .name = "width",
      .defaultValue = std::int64_t{ 1 },
      .help = "edges of each rim that it joins",
      .minimum = 1,
      .maximum = 999999 },
  });
  row.make = [](const ParameterValues& values) -> vtkSmartPointer<vtkAlgorithm>
  {
    const auto filter = newSurfaceFilter<vtkScanBridgeFilter>(values);
    if (const auto from = singlePoint(values, "from"))
    {
      filter->SetFrom(from->x, from->y, from->z);
    }
    if (const auto to = singlePoint(values, "to"))
    {
      filter->SetTo(to->x, to->y, to->z);
    }
    filter->SetWidth(static_cast<Index>(valueOf<std::int64_t>(values, "width")));
    return filter;
  };
  row.results = [](vtkAlgorithm& algorithm) -> Results
  {
    const auto& filter = as<vtkScanBridgeFilter>(algorithm);
    const BridgeResult& result = filter.GetResult();
    return surfaceResults(filter,
      { { "length", result.length }, { "joins-two-rims", result.joinsTwo },
        { "points-added", count(result.pointsAdded) },
        { "triangles-added", count(result.trianglesAdded) } });
  };
  return row;
}

Operation remeshOperation()
{
  Operation row;
  row.verb = "remesh";
  row.stage = Stage::surface;
  row.help = "Make nearly equilateral triangles of one size";
  row.example = "scanwrap scan.ply remesh --edge-length=0.5mm --keep-features=40 -o part.stl";
  row.parameters = surfaceParameters({
    { .name = "edge-length",
      .defaultValue = Length(),
      .help = "of the new triangles; 0: the mean of those that there are",
      .minimum = 0 },
    { .name = "iterations",
      .defaultValue = std::int64_t{ 5 },
      .help = "more are more even",
      .minimum = 1,
      .maximum = 100 },
    { .name = "keep-features",
      .defaultValue = 180.0,
      .help = "degrees: edges where the surface bends more stay; 180: none",
      .minimum = 0,
      .maximum = 180 },
  });
  row.make = [](const ParameterValues& values) -> vtkSmartPointer<vtkAlgorithm>
  {
    const auto filter = newSurfaceFilter<vtkScanRemeshFilter>(values);
    filter->SetEdgeLength(valueOf<Length>(values, "edge-length"));
    filter->SetIterations(static_cast<int>(valueOf<std::int64_t>(values, "iterations")));
    filter->SetKeepFeatures(valueOf<double>(values, "keep-features"));
    return filter;
  };
  row.results = [](vtkAlgorithm& algorithm) -> Results
  {
    const auto& filter = as<vtkScanRemeshFilter>(algorithm);
    const RemeshResult& result = filter.GetResult();
    return surfaceResults(filter,
      { { "edge-length", result.edgeLength }, { "edges-of-that-length", result.goodEdges },
        { "least-angle", result.leastAngle }, { "triangles-made", count(result.made) },
        { "triangles-held-back", count(result.heldBack) } });
  };
  return row;
}

} // namespace scan
