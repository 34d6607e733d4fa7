// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/surface/vtkScanMendFilter.h"
#include "filters/surface/vtkScanOrientFilter.h"
#include "pipeline/surface_rows.h"

#include <string>

namespace scan
{

namespace
{

void checkKinds(std::string_view text)
{
  static_cast<void>(parseDefectKinds(text));
}

/// Where defects of a kind are, the first ones.
std::string placesOf(const DefectList& list, DefectKind kind)
{
  constexpr std::size_t kMost = 10;
  PointList places;
  for (const Defect& defect : list.defects)
  {
    if (defect.kind == kind && places.size() < kMost)
    {
      places.push_back(defect.place);
    }
  }
  return textOf(ParameterValue(places));
}

/// Per kind how many were there and are left, and where.
Results defectResults(const MendResult& result)
{
  Results results;
  for (std::size_t i = 0; i < kDefectKinds; ++i)
  {
    const auto kind = static_cast<DefectKind>(i);
    const std::string name(kDefectNames.at(i));
    results.emplace_back(name, sizeOf(result.found.count(kind)));
    if (result.found.count(kind) > 0)
    {
      results.emplace_back(name + "-triangles", sizeOf(result.found.triangles(kind)));
      results.emplace_back(name + "-at", placesOf(result.found, kind));
    }
    if (result.left.count(kind) > 0)
    {
      results.emplace_back(name + "-left", sizeOf(result.left.count(kind)));
      results.emplace_back(name + "-left-at", placesOf(result.left, kind));
    }
  }
  return results;
}

Results tallyResults(const MendTally& tally)
{
  return { { "removed-degenerate", sizeOf(tally.degenerateRemoved) },
    { "added-by-cuts", sizeOf(tally.cutsAdded) },
    { "removed-duplicates", sizeOf(tally.duplicatesRemoved) },
    { "removed-in-small-components", sizeOf(tally.componentTriangles) },
    { "added-in-holes", sizeOf(tally.holeTriangles) },
    { "removed-intersecting", sizeOf(tally.intersections.removed) },
    { "added-for-intersecting", sizeOf(tally.intersections.added) },
    { "pieces-united", sizeOf(tally.intersections.unions) },
    { "triangles-turned", sizeOf(tally.turned) }, { "edges-split", sizeOf(tally.edgesSplit) },
    { "points-split", sizeOf(tally.pointsSplit) },
    { "seam-edges-closed", sizeOf(tally.seamsClosed) },
    { "points-moved", sizeOf(tally.pointsMoved) }, { "largest-move", tally.largestMove } };
}

} // namespace

Operation mendOperation()
{
  Operation row;
  row.verb = "mend";
  row.stage = Stage::surface;
  row.help = "Find what is wrong with the surface, and repair all of it or some";
  row.example = "scanwrap part.stl mend --fix=self-intersections,spikes -o mended.stl";
  row.parameters = surfaceParameters({
    { .name = "fix",
      .defaultValue = "all",
      .help = "all, or with commas: non-manifold-edges, non-manifold-points, self-intersections, "
              "degenerate, duplicates, inverted, spikes, small-components, small-holes, seams",
      .check = checkKinds },
    { .name = "preview",
      .defaultValue = false,
      .help = "only list the defects and say what would be done" },
    { .name = "mark",
      .defaultValue = false,
      .help = "repair nothing: make a region of the defects of each kind, with its name" },
    { .name = "at",
      .defaultValue = PointList(),
      .help = "x,y,z: only the defect nearest to there" },
    { .name = "least-height",
      .defaultValue = Length(1e-4, Length::Unit::diagonalPercent),
      .help = "lower triangles are degenerate; 0: only those without any area",
      .minimum = 0 },
    { .name = "spike",
      .defaultValue = 2.0,
      .help = "height of a spike over the radius of its neighbours",
      .minimum = 0.1 },
    { .name = "small-component",
      .defaultValue = 1.0,
      .help = "per cent of the triangles and of the area of the largest piece; 0: none is small",
      .minimum = 0,
      .maximum = 100 },
    { .name = "small-hole",
      .defaultValue = Length(10.0, Length::Unit::spacing),
      .help = "longest rim of a small hole; 0: none is small",
      .minimum = 0 },
  });
  row.make = [](const ParameterValues& values) -> vtkSmartPointer<vtkAlgorithm>
  {
    const auto filter = newSurfaceFilter<vtkScanMendFilter>(values);
    filter->SetKinds(parseDefectKinds(valueOf<std::string>(values, "fix")));
    filter->SetMark(valueOf<bool>(values, "mark") || valueOf<bool>(values, "preview"));
    if (const auto at = singlePoint(values, "at"))
    {
      filter->SetPlace(at->x, at->y, at->z);
    }
    filter->SetLeastHeight(valueOf<Length>(values, "least-height"));
    filter->SetSpikeRatio(valueOf<double>(values, "spike"));
    filter->SetSmallComponent(valueOf<double>(values, "small-component"));
    filter->SetSmallHole(valueOf<Length>(values, "small-hole"));
    return filter;
  };
  row.results = [](vtkAlgorithm& algorithm) -> Results
  {
    const auto& filter = as<vtkScanMendFilter>(algorithm);
    Results own = defectResults(filter.GetResult());
    const Results done = tallyResults(filter.GetResult().tally);
    own.insert(own.end(), done.begin(), done.end());
    return surfaceResults(filter, own);
  };
  return row;
}

Operation orientOperation()
{
  Operation row;
  row.verb = "orient";
  row.stage = Stage::surface;
  row.help = "Make the triangles agree which side is outside, or turn them over";
  row.example = "scanwrap part.obj orient -o part.stl";
  row.parameters = surfaceParameters({
    { .name = "outward",
      .defaultValue = true,
      .help = "closed pieces face outwards, voids in them inwards" },
    { .name = "flip",
      .defaultValue = false,
      .help = "only turn over all triangles, or those of the region" },
  });
  row.make = [](const ParameterValues& values) -> vtkSmartPointer<vtkAlgorithm>
  {
    const auto filter = newSurfaceFilter<vtkScanOrientFilter>(values);
    filter->SetOutward(valueOf<bool>(values, "outward"));
    filter->SetFlip(valueOf<bool>(values, "flip"));
    return filter;
  };
  row.results = [](vtkAlgorithm& algorithm) -> Results
  {
    const auto& filter = as<vtkScanOrientFilter>(algorithm);
    const OrientResult& result = filter.GetResult();
    return surfaceResults(filter,
      { { "triangles-turned", count(result.turned) }, { "pieces", count(result.pieces) },
        { "disagreeing-pieces", count(result.disagreeingPieces) } });
  };
  return row;
}

} // namespace scan
