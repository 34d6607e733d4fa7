// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/surface/vtkScanRefineFilter.h"
#include "pipeline/surface_rows.h"

#include <string>
#include <vector>

namespace scan
{

namespace
{

/// In the order of RefineOptions::Mode.
const std::vector<std::string> kRefineModes{ "loop", "midpoint" };

} // namespace

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
      .minimum = 0,
      .maximum = 180 },
  });
  row.make = [](const ParameterValues& values) -> vtkSmartPointer<vtkAlgorithm>
  {
    const auto filter = newSurfaceFilter<vtkScanRefineFilter>(values);
    filter->SetMode(static_cast<RefineOptions::Mode>(choiceOf(values, "mode", kRefineModes)));
    filter->SetTimes(static_cast<int>(valueOf<std::int64_t>(values, "times")));
    filter->SetCreaseAngle(valueOf<double>(values, "crease-angle"));
    return filter;
  };
  row.results = [](vtkAlgorithm& algorithm) -> Results
  {
    const auto& filter = as<vtkScanRefineFilter>(algorithm);
    const RefineResult& result = filter.GetResult();
    return surfaceResults(filter,
      { { "points-added", count(filter.GetPointsAdded()) },
        { "cut-in-four", sizeOf(result.cutInFour) }, { "cut-in-two", sizeOf(result.cutInTwo) },
        { "halves-joined", sizeOf(result.joined) }, { "points-held-back", sizeOf(result.heldBack) },
        { "largest-shift", result.largestShift } });
  };
  return row;
}

} // namespace scan
