// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/points/vtkScanAddPointsFilter.h"
#include "filters/points/vtkScanAlignFilter.h"
#include "filters/points/vtkScanDenoiseFilter.h"
#include "filters/points/vtkScanNormalsFilter.h"
#include "filters/points/vtkScanRemoveOutliersFilter.h"
#include "filters/points/vtkScanThinFilter.h"
#include "pipeline/merge_file.h"
#include "pipeline/operation_rows.h"

#include <string>

namespace scan
{

namespace
{

/// In the order of ThinOptions::By and PointNormalOptions::Orient.
const std::vector<std::string> kThinBy{ "random", "spacing", "grid", "curvature" };
const std::vector<std::string> kOrients{ "outward", "toward", "none" };

/// In the order of kViewSides.
const std::vector<std::string> kSides = viewNames();

Parameter neighboursParameter(std::int64_t standard, double least, const std::string& help)
{
  return {
    .name = "neighbours", .defaultValue = standard, .help = help, .minimum = least, .maximum = 1000
  };
}

Index neighboursOf(const ParameterValues& values)
{
  return static_cast<Index>(valueOf<std::int64_t>(values, "neighbours"));
}

template <class Filter>
Results pointCounts(vtkAlgorithm& algorithm)
{
  const auto& filter = as<Filter>(algorithm);
  return { { "points-before", count(filter.GetPointsBefore()) },
    { "points-after", count(filter.GetPointsAfter()) } };
}

Operation thinOperation()
{
  Operation row;
  row.verb = "thin";
  row.stage = Stage::points;
  row.help = "Keep fewer points, all of them points of the scan";
  row.example = "scanwrap scan.xyz thin --by=curvature --keep=10 wrap -o part.stl";
  row.parameters = {
    { .name = "by",
      .defaultValue = "spacing",
      .help =
        "random: all alike; spacing: none too near; grid: one per cube; curvature: most where "
        "the surface bends",
      .choices = kThinBy },
    { .name = "keep",
      .defaultValue = 25.0,
      .help = "random and curvature: per cent of the points that stay",
      .minimum = 0,
      .maximum = 100 },
    { .name = "spacing",
      .defaultValue = Length(2.0, Length::Unit::spacing),
      .help = "spacing: no two points nearer than this; grid: the side of a cube; 0 drops repeated "
              "points only",
      .minimum = 0 },
    { .name = "seed",
      .defaultValue = std::int64_t{ 1 },
      .help = "random and curvature: another number gives another choice" },
    regionParameter(),
  };
  row.make = [](const ParameterValues& values) -> vtkSmartPointer<vtkAlgorithm>
  {
    const auto filter = vtkSmartPointer<vtkScanThinFilter>::New();
    filter->SetBy(static_cast<ThinOptions::By>(choiceOf(values, "by", kThinBy)));
    filter->SetKeep(valueOf<double>(values, "keep"));
    filter->SetSpacing(valueOf<Length>(values, "spacing"));
    filter->SetSeed(static_cast<std::uint64_t>(valueOf<std::int64_t>(values, "seed")));
    filter->SetRegion(valueOf<std::string>(values, "region"));
    return filter;
  };
  row.results = pointCounts<vtkScanThinFilter>;
  return row;
}

Operation removeOutliersOperation()
{
  Operation row;
  row.verb = "remove-outliers";
  row.stage = Stage::points;
  row.help = "Remove stray points: single ones, thin clouds and small clumps far from the rest";
  row.example = "scanwrap scan.ply remove-outliers wrap -o part.stl";
  row.parameters = {
    neighboursParameter(16, 4, "points that each is compared with"),
    { .name = "factor",
      .defaultValue = 3.0,
      .help = "a point is stray when it is so many times as far from its neighbours as usual there",
      .minimum = 1 },
    regionParameter(),
  };
  row.make = [](const ParameterValues& values) -> vtkSmartPointer<vtkAlgorithm>
  {
    const auto filter = vtkSmartPointer<vtkScanRemoveOutliersFilter>::New();
    filter->SetNeighbours(neighboursOf(values));
    filter->SetFactor(valueOf<double>(values, "factor"));
    filter->SetRegion(valueOf<std::string>(values, "region"));
    return filter;
  };
  row.results = [](vtkAlgorithm& filter) -> Results
  {
    const OutlierResult& found = as<vtkScanRemoveOutliersFilter>(filter).GetResult();
    const std::size_t removed = found.single + found.together;
    return { { "points-before", sizeOf(found.isStray.size()) },
      { "points-after", sizeOf(found.isStray.size() - removed) },
      { "points-removed", sizeOf(removed) }, { "removed-single", sizeOf(found.single) },
      { "removed-in-clouds-and-clumps", sizeOf(found.together) } };
  };
  return row;
}

Operation denoiseOperation()
{
  Operation row;
  row.verb = "denoise";
  row.stage = Stage::points;
  row.help = "Move points onto the surface that their neighbours suggest";
  row.example = "scanwrap scan.xyz denoise --max-shift=0.1mm wrap -o part.stl";
  row.parameters = {
    { .name = "max-shift",
      .defaultValue = Length(2.0, Length::Unit::spacing),
      .help = "no point moves farther, all iterations together",
      .minimum = 0 },
    { .name = "iterations",
      .defaultValue = std::int64_t{ 3 },
      .help = "more are smoother",
      .minimum = 1,
      .maximum = 100 },
    neighboursParameter(32, 8, "points that a surface is fitted to; more are smoother"),
    regionParameter(),
  };
  row.make = [](const ParameterValues& values) -> vtkSmartPointer<vtkAlgorithm>
  {
    const auto filter = vtkSmartPointer<vtkScanDenoiseFilter>::New();
    filter->SetMaxShift(valueOf<Length>(values, "max-shift"));
    filter->SetIterations(static_cast<int>(valueOf<std::int64_t>(values, "iterations")));
    filter->SetNeighbours(neighboursOf(values));
    filter->SetRegion(valueOf<std::string>(values, "region"));
    return filter;
  };
  row.results = [](vtkAlgorithm& algorithm) -> Results
  {
    const auto& filter = as<vtkScanDenoiseFilter>(algorithm);
    const DenoiseResult& result = filter.GetResult();
    return { { "points-moved", sizeOf(result.moved) }, { "max-shift", filter.GetLimit() },
      { "points-at-max-shift", sizeOf(result.limited) }, { "mean-shift", result.meanShift },
      { "largest-shift", result.largestShift } };
  };
  return row;
}

Operation normalsOperation()
{
  Operation row;
  row.verb = "normals";
  row.stage = Stage::points;
  row.help = "Give the points normals that agree which side is outside";
  row.example = "scanwrap scan.xyz normals -o scan.ply";
  row.parameters = {
    neighboursParameter(16, 3, "points that suggest a plane; more for noisy scans"),
    { .name = "orient",
      .defaultValue = "outward",
      .help = "outward: away from the inside, or up where there is none; toward: to the viewpoint; "
              "none: any side",
      .choices = kOrients },
    { .name = "viewpoint",
      .defaultValue = PointList(),
      .help = "toward: where the scanner stood, x,y,z; the origin where it is not given" },
    regionParameter(),
  };
  row.make = [](const ParameterValues& values) -> vtkSmartPointer<vtkAlgorithm>
  {
    const auto filter = vtkSmartPointer<vtkScanNormalsFilter>::New();
    filter->SetNeighbours(neighboursOf(values));
    filter->SetOrient(
      static_cast<PointNormalOptions::Orient>(choiceOf(values, "orient", kOrients)));
    if (const auto viewpoint = singlePoint(values, "viewpoint"))
    {
      filter->SetViewpoint(viewpoint->x, viewpoint->y, viewpoint->z);
    }
    filter->SetRegion(valueOf<std::string>(values, "region"));
    return filter;
  };
  row.results = [](vtkAlgorithm& filter) -> Results
  {
    const PointNormalResult& result = as<vtkScanNormalsFilter>(filter).GetResult();
    return { { "points-without-normal", sizeOf(result.undecided) },
      { "connected-parts", sizeOf(result.parts) }, { "open-parts", sizeOf(result.openParts) } };
  };
  return row;
}

Operation addOperation()
{
  Operation row;
  row.verb = "add";
  row.stage = Stage::points;
  row.help = "Add points at places of your own";
  row.example =
    "scanwrap scan.xyz add --at=1,2,0 --at=3,2,0 --view=top --depth=0,0,1.5 wrap -o a.stl";
  row.parameters = {
    { .name = "at", .defaultValue = PointList(), .help = "this point, or these; may be repeated" },
    { .name = "view",
      .defaultValue = "front",
      .help = "with --depth: the side that the model is looked at from",
      .choices = kSides },
    { .name = "depth",
      .defaultValue = PointList(),
      .help = "x,y,z: moves the new points along the view, as deep as this point" },
  };
  row.make = [](const ParameterValues& values) -> vtkSmartPointer<vtkAlgorithm>
  {
    const auto filter = vtkSmartPointer<vtkScanAddPointsFilter>::New();
    for (const Vec3& p : valueOf<PointList>(values, "at"))
    {
      filter->AddPoint(p.x, p.y, p.z);
    }
    if (const auto depth = singlePoint(values, "depth"))
    {
      const Vec3 towards =
        kViewSides.at(static_cast<std::size_t>(choiceOf(values, "view", kSides))).towards;
      using Filter = vtkScanAddPointsFilter;
      towards.x != 0.0     ? filter->SetDepth(Filter::X, depth->x)
        : towards.y != 0.0 ? filter->SetDepth(Filter::Y, depth->y)
                           : filter->SetDepth(Filter::Z, depth->z);
    }
    return filter;
  };
  row.results = pointCounts<vtkScanAddPointsFilter>;
  return row;
}

Operation mergeOperation()
{
  Operation row;
  row.verb = "merge";
  row.stage = Stage::points;
  row.help = "Append the points of another file";
  row.example = "scanwrap front.ply remove-outliers merge --file=back.ply align wrap -o part.stl";
  row.parameters = {
    { .name = "file", .defaultValue = "", .help = "its name; any format that can be read" },
  };
  row.make = [](const ParameterValues& values) -> vtkSmartPointer<vtkAlgorithm>
  {
    const auto filter = vtkSmartPointer<MergeFile>::New();
    filter->SetPath(valueOf<std::string>(values, "file"));
    return filter;
  };
  row.results = pointCounts<MergeFile>;
  return row;
}

Operation alignOperation()
{
  Operation row;
  row.verb = "align";
  row.stage = Stage::points;
  row.help = "Move one of several scans onto the others: by picked pairs, then where it fits best";
  row.example = "scanwrap front.ply back.ply align --scan=2 --from='1,2,3;4,5,6;7,8,0' "
                "--onto='1,2,4;4,5,7;7,8,1' wrap -o part.stl";
  row.parameters = {
    { .name = "scan",
      .defaultValue = "",
      .help = "the file that moves, by its number from 1 or its name; empty: the last one" },
    { .name = "from",
      .defaultValue = PointList(),
      .help = "three places on it or more, for a first placement; may be repeated" },
    { .name = "onto",
      .defaultValue = PointList(),
      .help = "where these belong on the others, in the same order" },
    { .name = "fit",
      .defaultValue = true,
      .help = "then move it to where it fits the others best" },
  };
  row.make = [](const ParameterValues& values) -> vtkSmartPointer<vtkAlgorithm>
  {
    const auto filter = vtkSmartPointer<vtkScanAlignFilter>::New();
    filter->SetScan(valueOf<std::string>(values, "scan"));
    for (const Vec3& p : valueOf<PointList>(values, "from"))
    {
      filter->AddFrom(p.x, p.y, p.z);
    }
    for (const Vec3& p : valueOf<PointList>(values, "onto"))
    {
      filter->AddOnto(p.x, p.y, p.z);
    }
    filter->SetFit(valueOf<bool>(values, "fit"));
    return filter;
  };
  row.results = [](vtkAlgorithm& algorithm) -> Results
  {
    const auto& filter = as<vtkScanAlignFilter>(algorithm);
    const AlignResult& result = filter.GetResult();
    Results results{ { "scan", filter.GetFileName() }, { "angle", result.angleDegrees },
      { "shift", result.shift } };
    if (filter.GetNumberOfPairs() > 0)
    {
      results.insert(results.end(),
        { { "pairs", sizeOf(filter.GetNumberOfPairs()) }, { "pairs-rms", result.pairRms } });
    }
    if (result.samples > 0)
    {
      results.insert(results.end(),
        { { "fit-points", sizeOf(result.samples) }, { "fit-points-used", sizeOf(result.used) },
          { "fit-iterations", count(result.iterations) }, { "fit-rms", result.rms },
          { "fit-mean", result.mean }, { "fit-largest", result.largest } });
    }
    return results;
  };
  return row;
}

} // namespace

std::vector<Operation> pointOperations()
{
  return { thinOperation(), removeOutliersOperation(), denoiseOperation(), normalsOperation(),
    addOperation(), mergeOperation(), alignOperation() };
}

} // namespace scan
