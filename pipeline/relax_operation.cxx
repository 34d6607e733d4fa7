// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/surface/vtkScanRelaxFilter.h"
#include "pipeline/surface_rows.h"

#include <string>
#include <vector>

namespace scan
{

namespace
{

const std::vector<std::string> kRelaxBoundary = { "keep", "relax" };

} // namespace

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
    const auto& filter = as<vtkScanRelaxFilter>(algorithm);
    const RelaxResult& result = filter.GetResult();
    Results own{ { "points-moved", sizeOf(result.moved) },
      { "points-at-max-deviation", sizeOf(result.limited) },
      { "feature-edges", sizeOf(result.featureEdges) },
      { "feature-corners", sizeOf(result.featureCorners) }, { "mean-shift", result.meanShift },
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

} // namespace scan
