// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/base/error.h"
#include "filters/surface/vtkScanDecimateFilter.h"
#include "pipeline/surface_rows.h"

#include <charconv>
#include <string_view>

namespace scan
{
namespace
{

const std::vector<std::string> kMethods{ "quadric", "openmesh" }; // as in the filter

/// "10%" or "0.1", more than 0 and at most all.
double parseRatio(std::string_view text)
{
  const bool isPercent = text.ends_with('%');
  const std::string_view digits = text.substr(0, text.size() - (isPercent ? 1 : 0));
  double number = 0.0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  const double ratio = isPercent ? number / 100.0 : number;
  if (error != std::errc() || end != digits.data() + digits.size() ||
    !(ratio > 0.0 && ratio <= 1.0))
  {
    throw Error(ErrorCode::badParameter,
      "--ratio: expected a share of the triangles such as 10% or 0.1, more than 0 and at most "
      "100%");
  }
  return ratio;
}

} // namespace

Operation decimateOperation()
{
  Operation row;
  row.verb = "decimate";
  row.stage = Stage::surface;
  row.help = "Reduce the triangles where they tell least; without a target to half of them";
  row.example = "scanwrap scan.xyz wrap decimate --ratio=10% --max-deviation=0.05mm -o part.stl";
  row.parameters = surfaceParameters({
    { .name = "ratio",
      .defaultValue = "",
      .help = "share of the triangles to leave, such as 10%",
      .check = [](std::string_view text) { parseRatio(text); } },
    { .name = "triangles",
      .defaultValue = std::int64_t{ 0 },
      .help = "how many to leave; 0: see ratio; with max-deviation alone as few as it allows",
      .minimum = 0 },
    { .name = "crease-angle",
      .defaultValue = 90.0,
      .help = "quadric: edges that turn by more degrees keep their line, as boundaries do",
      .minimum = 0,
      .maximum = 180 },
    { .name = "method",
      .defaultValue = "quadric",
      .help = "quadric: fast, points in the best places, no self-intersections; openmesh: keeps "
              "the conditions below, points stay in their places",
      .choices = kMethods },
    { .name = "max-normal-deviation",
      .defaultValue = 180.0,
      .help = "openmesh: what a triangle stands for turns by no more degrees; 180: no condition",
      .minimum = 0,
      .maximum = 180 },
    { .name = "longest-edge",
      .defaultValue = Length(),
      .help = "openmesh: no edge becomes longer; 0: no condition",
      .minimum = 0 },
    { .name = "max-aspect-ratio",
      .defaultValue = 0.0,
      .help = "openmesh: length over height of a triangle; 0: no condition",
      .minimum = 0 },
  });
  row.make = [](const ParameterValues& values) -> vtkSmartPointer<vtkAlgorithm>
  {
    const auto filter = newSurfaceFilter<vtkScanDecimateFilter>(values);
    if (const auto& ratio = valueOf<std::string>(values, "ratio"); !ratio.empty())
    {
      filter->SetRatio(parseRatio(ratio));
    }
    filter->SetTriangles(valueOf<std::int64_t>(values, "triangles"));
    filter->SetCreaseAngle(valueOf<double>(values, "crease-angle"));
    filter->SetMethod(
      static_cast<vtkScanDecimateFilter::Method>(choiceOf(values, "method", kMethods)));
    filter->SetMaxNormalDeviation(valueOf<double>(values, "max-normal-deviation"));
    filter->SetLongestEdge(valueOf<Length>(values, "longest-edge"));
    filter->SetMaxAspectRatio(valueOf<double>(values, "max-aspect-ratio"));
    return filter;
  };
  row.results = [](vtkAlgorithm& algorithm) -> Results
  {
    const auto& filter = as<vtkScanDecimateFilter>(algorithm);
    const DecimateResult& result = filter.GetResult();
    return surfaceResults(filter,
      { { "points-moved", sizeOf(result.pointsMoved) },
        { "new-self-intersections", sizeOf(result.intersections) },
        { "runs", sizeOf(result.rounds) } });
  };
  return row;
}

} // namespace scan
