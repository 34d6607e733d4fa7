// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/regions/vtkScanCropFilter.h"
#include "filters/regions/vtkScanSelectFilter.h"
#include "pipeline/operation_rows.h"

namespace scan
{

namespace
{

Operation selectOperation()
{
  Operation row;
  row.verb = "select";
  row.stage = Stage::points;
  row.help = "Name a region of the model, for --region of other operations";
  row.example = "scanwrap scan.xyz select --name=near --rule='plane(0,0,0, 0,-1,0)' "
                "crop --region=near -o near.ply";
  row.parameters = {
    { .name = "name",
      .defaultValue = "",
      .help = "of the region: letters, digits, - and _; in place of an earlier one" },
    { .name = "rule",
      .defaultValue = "",
      .help = "what belongs to it, such as 'sphere(0,0,0,5) & !box(0,0,0,1,1,1)'; see the manual",
      .check = checkRegionRule },
  };
  row.make = [](const ParameterValues& values) -> vtkSmartPointer<vtkAlgorithm>
  {
    const auto filter = vtkSmartPointer<vtkScanSelectFilter>::New();
    filter->SetName(valueOf<std::string>(values, "name"));
    filter->SetRule(valueOf<std::string>(values, "rule"));
    return filter;
  };
  row.results = [](vtkAlgorithm& algorithm) -> Results
  {
    const auto& filter = as<vtkScanSelectFilter>(algorithm);
    return {
      { "region-points", count(filter.GetPoints()) },
      { "region-triangles", count(filter.GetTriangles()) },
      { "region-share", filter.GetShare() },
      { "rule", filter.GetStoredRule() },
    };
  };
  return row;
}

Operation cropOperation(std::string verb, std::string help, std::string example, bool erase)
{
  Operation row;
  row.verb = std::move(verb);
  row.stage = Stage::points;
  row.help = std::move(help);
  row.example = std::move(example);
  row.parameters = { regionParameter() };
  row.make = [erase](const ParameterValues& values) -> vtkSmartPointer<vtkAlgorithm>
  {
    const auto filter = vtkSmartPointer<vtkScanCropFilter>::New();
    filter->SetRegion(valueOf<std::string>(values, "region"));
    filter->SetErase(erase);
    return filter;
  };
  row.results = [](vtkAlgorithm& algorithm) -> Results
  {
    const auto& filter = as<vtkScanCropFilter>(algorithm);
    return { { "points-gone", count(filter.GetPointsGone()) },
      { "triangles-gone", count(filter.GetTrianglesGone()) } };
  };
  return row;
}

} // namespace

std::vector<Operation> regionOperations()
{
  return { selectOperation(),
    cropOperation("crop", "Keep only what is in a region: triangles of a surface, points of a scan",
      "scanwrap scan.xyz crop --region='box(0,0,0, 9,9,9)' -o part.ply", false),
    cropOperation("erase", "Remove what is in a region: triangles of a surface, points of a scan",
      "scanwrap scan.xyz erase --region='sphere(0,0,0, 2mm)' wrap -o part.stl", true) };
}

} // namespace scan
