// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/surface/vtkScanRefineFilter.h"
#include "filters/surface/vtkScanRelaxFilter.h"
#include "pipeline/surface_rows.h"

#include <string>
#include <vector>

namespace scan
{

std::vector<Parameter> surfaceParameters(std::vector<Parameter> own)
{
  own.push_back({ .name = "max-deviation",
    .defaultValue = Length(),
    .help = "the surface stays this near to where it was; 0: no limit",
    .minimum = 0 });
  own.push_back(
    { .name = "measure", .defaultValue = true, .help = "measure how far the surface moves" });
  own.push_back(regionParameter());
  return own;
}

void setSurfaceProperties(vtkScanSurfaceFilter& filter, const ParameterValues& values)
{
  filter.SetMaxDeviation(valueOf<Length>(values, "max-deviation"));
  filter.SetMeasure(valueOf<bool>(values, "measure"));
  filter.SetRegion(valueOf<std::string>(values, "region"));
}

Results surfaceResults(const vtkScanSurfaceFilter& filter, const Results& own)
{
  Results results{ { "triangles-before", count(filter.GetTrianglesBefore()) },
    { "triangles-after", count(filter.GetTrianglesAfter()) } };
  results.insert(results.end(), own.begin(), own.end());
  if (const auto& moved = filter.GetDeviation())
  {
    results.insert(results.end(),
      { { "mean-deviation", moved->mean }, { "largest-deviation", moved->largest },
        { "largest-deviation-at-most", moved->atMost },
        { "largest-deviation-at", textOf(ParameterValue(PointList{ moved->where })) } });
  }
  return results;
}

namespace
{

/// In the order of RefineOptions::Mode.
const std::vector<std::string> kRefineModes{ "loop", "midpoint" };

Operation refineOperation()
{
  Operation row;
  row.verb = "refine";
  row.stage = Stage::surface;
  row.help = "Cut triangles into four, and move points to where a smooth surface suggests";
  row.example = "scanwrap scan.xyz wrap refine --times=2 -o part.stl";
  row.parameters = surfaceParameters({
    { .name = "mode",
      .defaultValue = "loop",
      .help = "loop: points move onto a smooth surface; midpoint: the surface stays where it is",
      .choices = kRefineModes },
    { .name = "times",
      .defaultValue = std::int64_t{ 1 },
      .help = "each time there are four times as many triangles",
      .minimum = 1,
      .maximum = 8 },
    { .name = "crease-angle",
      .defaultValue = 180.0,
      .help = "loop: edges that bend by more degrees stay sharp; 180: none",
const std::vector<std::string> kRelaxBoundary = { "keep", "relax" };

Operation relaxOperation()
{
  Operation row;
  row.verb = "relax";
  row.stage = Stage::surface;
  row.help = "Take noise out of the surface, without shrinking it";
  row.example = "scanwrap scan.xyz wrap relax --max-deviation=0.1mm -o part.stl";
  row.parameters = surfaceParameters({
    { .name = "iterations",
      .defaultValue = std::int64_t{ 50 },
      .help = "more are smoother",
      .minimum = 1,
      .maximum = 10000 },
    { .name = "lambda",
      .defaultValue = 0.7,
      .help = "how far a point moves towards the mean of its neighbours, above 0",
      .minimum = 0,
      .maximum = 1 },
    { .name = "mu",
      .defaultValue = -0.705,
      .help = "and back, so that nothing shrinks; a little below -lambda",
      .minimum = -1.1,
      .maximum = 0 },
    { .name = "boundary",
      .defaultValue = "keep",
      .help = "keep the boundary as it is, or relax it along itself",
      .choices = kRelaxBoundary },
    { .name = "keep-features",
      .defaultValue = 0.0,
      .help = "degrees: edges that bend by more stay sharp, and are cleaned; 0: none",
      .minimum = 0,
      .maximum = 180 },
  });
  row.make = [](const ParameterValues& values) -> vtkSmartPointer<vtkAlgorithm>
  {
    const auto filter = newSurfaceFilter<vtkScanRefineFilter>(values);
    filter->SetMode(static_cast<RefineOptions::Mode>(choiceOf(values, "mode", kRefineModes)));
    filter->SetTimes(static_cast<int>(valueOf<std::int64_t>(values, "times")));
    filter->SetCreaseAngle(valueOf<double>(values, "crease-angle"));
    const auto filter = newSurfaceFilter<vtkScanRelaxFilter>(values);
    filter->SetIterations(static_cast<int>(valueOf<std::int64_t>(values, "iterations")));
    filter->SetLambda(valueOf<double>(values, "lambda"));
    filter->SetMu(valueOf<double>(values, "mu"));
    filter->SetBoundary(
      static_cast<RelaxOptions::Boundary>(choiceOf(values, "boundary", kRelaxBoundary)));
    filter->SetKeepFeatures(valueOf<double>(values, "keep-features"));
    return filter;
  };
  row.results = [](vtkAlgorithm& algorithm) -> Results
  {
    const auto& filter = as<vtkScanRefineFilter>(algorithm);
    const RefineResult& result = filter.GetResult();
    return surfaceResults(filter,
      { { "points-added", count(filter.GetPointsAdded()) },
        { "cut-in-four", count(static_cast<std::int64_t>(result.cutInFour)) },
        { "cut-in-two", count(static_cast<std::int64_t>(result.cutInTwo)) },
        { "halves-joined", count(static_cast<std::int64_t>(result.joined)) },
        { "points-held-back", count(static_cast<std::int64_t>(result.heldBack)) },
        { "largest-shift", result.largestShift } });
    const auto& filter = as<vtkScanRelaxFilter>(algorithm);
    const RelaxResult& result = filter.GetResult();
    const auto number = [](std::size_t n) { return count(static_cast<std::int64_t>(n)); };
    Results own{ { "points-moved", number(result.moved) },
      { "points-at-max-deviation", number(result.limited) },
      { "feature-edges", number(result.featureEdges) },
      { "feature-corners", number(result.featureCorners) }, { "mean-shift", result.meanShift },
      { "largest-shift", result.largestShift } };
    if (result.volumeBefore)
    {
      own.insert(own.end(),
        { { "volume-before", *result.volumeBefore }, { "volume-after", *result.volumeAfter } });
    }
    return surfaceResults(filter, own);
  };
  return row;
}

} // namespace

std::vector<Operation> surfaceOperations()
{
  return { decimateOperation(), thickenOperation(), offsetOperation(), sharpenOperation(), refineOperation(), relaxOperation(), fillHolesOperation(), bridgeOperation(), remeshOperation() };
}

} // namespace scan
