// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/surface_rows.h"

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

std::vector<Operation> surfaceOperations()
{
  return { mendOperation(), orientOperation(), fillHolesOperation(), bridgeOperation(),
    refineOperation(), relaxOperation(), decimateOperation(), remeshOperation(), thickenOperation(),
    offsetOperation(), sharpenOperation() };
}

} // namespace scan
