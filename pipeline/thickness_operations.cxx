// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/surface/vtkScanOffsetFilter.h"
#include "filters/surface/vtkScanSharpenFilter.h"
#include "filters/surface/vtkScanThickenFilter.h"
#include "pipeline/surface_rows.h"

namespace scan
{
namespace
{

const std::vector<std::string> kSides{ "both", "out", "in" }; // as in ThickenSide

/// Where a surface folds onto itself.
Results foldResults(const SurfaceFolds& folds)
{
  constexpr std::size_t kNamed = 5;
  const auto end =
    folds.places.begin() + static_cast<std::ptrdiff_t>(std::min(kNamed, folds.places.size()));
  Results results{ { "triangles-folded", count(folds.folded) },
    { "triangles-turned", count(folds.turned) }, { "triangles-shrunk", count(folds.shrunk) },
    { "triangles-crossing", count(folds.crossing) },
    { "folded-places", sizeOf(folds.places.size()) } };
  if (!folds.places.empty())
  {
    results.emplace_back("folded-at", textOf(ParameterValue(PointList(folds.places.begin(), end))));
  }
  return results;
}

} // namespace

Operation thickenOperation()
{
  Operation row;
  row.verb = "thicken";
  row.stage = Stage::surface;
  row.help = "Make a surface a solid of uniform thickness; a region becomes a solid of its own";
  row.example = "scanwrap scan.xyz wrap thicken --thickness=2mm --side=in -o part.stl";
  row.parameters = surfaceParameters({
    { .name = "thickness",
      .defaultValue = Length(2.0, Length::Unit::spacing),
      .help = "of the solid, more than 0",
      .minimum = 0 },
    { .name = "side",
      .defaultValue = "both",
      .help = "where the solid is: half on both sides, or out to where the surface faces, or in",
      .choices = kSides },
  });
  row.make = [](const ParameterValues& values) -> vtkSmartPointer<vtkAlgorithm>
  {
    const auto filter = newSurfaceFilter<vtkScanThickenFilter>(values);
    filter->SetThickness(valueOf<Length>(values, "thickness"));
    filter->SetSide(static_cast<ThickenSide>(choiceOf(values, "side", kSides)));
    return filter;
  };
  row.results = [](vtkAlgorithm& algorithm) -> Results
  {
    const auto& filter = as<vtkScanThickenFilter>(algorithm);
    const ThickenResult& result = filter.GetResult();
    Results own{ { "thickness", filter.GetThickness() }, { "strip-triangles", count(result.strip) },
      { "points-held-back", count(result.heldBack) } };
    const Results folds = foldResults(result.folds);
    own.insert(own.end(), folds.begin(), folds.end());
    return surfaceResults(filter, own);
  };
  return row;
}

Operation offsetOperation()
{
  Operation row;
  row.verb = "offset";
  row.stage = Stage::surface;
  row.help = "Move a surface along its normals: grow or shrink a solid";
  row.example = "scanwrap scan.xyz wrap offset --distance=-0.5mm -o smaller.stl";
  row.parameters = surfaceParameters({
    { .name = "distance",
      .defaultValue = Length(1.0, Length::Unit::spacing),
      .help = "to where the surface faces; negative: the other way, inwards" },
  });
  row.make = [](const ParameterValues& values) -> vtkSmartPointer<vtkAlgorithm>
  {
    const auto filter = newSurfaceFilter<vtkScanOffsetFilter>(values);
    filter->SetDistance(valueOf<Length>(values, "distance"));
    return filter;
  };
  row.results = [](vtkAlgorithm& algorithm) -> Results
  {
    const auto& filter = as<vtkScanOffsetFilter>(algorithm);
    const OffsetResult& result = filter.GetResult();
    Results own{ { "distance", filter.GetDistance() }, { "points-moved", count(result.moved) },
      { "points-held-back", count(result.heldBack) } };
    const Results folds = foldResults(result.folds);
    own.insert(own.end(), folds.begin(), folds.end());
    return surfaceResults(filter, own);
  };
  return row;
}

Operation sharpenOperation()
{
  Operation row;
  row.verb = "sharpen";
  row.stage = Stage::surface;
  row.help = "Make edges and corners sharp that the points of a scan have missed";
  row.example = "scanwrap scan.xyz wrap sharpen -o part.stl";
  row.parameters = surfaceParameters({
    { .name = "angle",
      .defaultValue = 20.0,
      .help = "degrees: where triangles turn by more, the surface is not smooth",
      .minimum = 0.1,
      .maximum = 89.9 },
  });
  row.make = [](const ParameterValues& values) -> vtkSmartPointer<vtkAlgorithm>
  {
    const auto filter = newSurfaceFilter<vtkScanSharpenFilter>(values);
    filter->SetAngle(valueOf<double>(values, "angle"));
    return filter;
  };
  row.results = [](vtkAlgorithm& algorithm) -> Results
  {
    const auto& filter = as<vtkScanSharpenFilter>(algorithm);
    const SharpenResult& result = filter.GetResult();
    return surfaceResults(filter,
      { { "edges-cut", count(result.edges) }, { "corners-cut", count(result.corners) },
        { "edges-left", count(result.leftOut) }, { "points-held-back", count(result.heldBack) } });
  };
  return row;
}

} // namespace scan
