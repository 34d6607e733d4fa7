// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/analysis/vtkScanInfoFilter.h"
#include "filters/base/vtkScanArrayNames.h"
#include "filters/base/vtkScanMeshBridge.h"
#include "filters/base/vtkScanRegions.h"
#include "filters/regions/vtkScanCropFilter.h"
#include "filters/regions/vtkScanSelectFilter.h"
#include "filters/wrap/vtkScanFlattenFilter.h"
#include "filters/wrap/vtkScanPushFilter.h"
#include "filters/wrap/vtkScanWrapFilter.h"

#include <gtest/gtest.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>

#include <cmath>
#include <numbers>
#include <random>

using namespace scan;
using State = vtkScanOutcome::State;

namespace
{

vtkSmartPointer<vtkPolyData> dataOf(const TriMesh& mesh)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  bridge::setMesh(*data, mesh);
  bridge::setUnit(*data, 25.4);
  return data;
}

/// Random points of a sphere of radius 1.
vtkSmartPointer<vtkPolyData> sphere(std::size_t count)
{
  std::mt19937_64 random(3);
  std::normal_distribution<double> at;
  TriMesh mesh;
  for (std::size_t i = 0; i < count; ++i)
  {
    const Vec3 p{ at(random), at(random), at(random) };
    mesh.points.push_back(p * (1.0 / std::sqrt(dot(p, p))));
  }
  return dataOf(mesh);
}

/// Random points of a tube, open at both ends.
vtkSmartPointer<vtkPolyData> tube()
{
  std::mt19937_64 random(6);
  std::uniform_real_distribution<double> at(0.0, 1.0);
  TriMesh mesh;
  for (int i = 0; i < 2000; ++i)
  {
    const double angle = 2.0 * std::numbers::pi * at(random);
    mesh.points.push_back({ std::cos(angle), std::sin(angle), 6.0 * at(random) });
  }
  return dataOf(mesh);
}

template <class Array>
void number(vtkFieldData& data, const char* name, vtkIdType count)
{
  vtkNew<Array> array;
  array->SetName(name);
  for (vtkIdType i = 0; i < count; ++i)
  {
    array->InsertNextTuple1(static_cast<double>(i));
  }
  data.AddArray(array);
}

/// A quad and a triangle beside each other on y >= 0, another quad below, a curve along the top.
vtkSmartPointer<vtkPolyData> patches()
{
  auto data = dataOf({ { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 2, 0, 0 },
                         { 0, -1, 0 }, { 1, -1, 0 }, { 5, 5, 5 } },
    {} });
  vtkNew<vtkCellArray> polygons;
  for (const auto& corners :
    std::vector<std::vector<vtkIdType>>{ { 0, 1, 2, 3 }, { 1, 4, 2 }, { 5, 6, 1, 0 } })
  {
    polygons->InsertNextCell(static_cast<vtkIdType>(corners.size()), corners.data());
  }
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ 3, 2 });
  lines->InsertNextCell({ 5, 7 });
  data->SetVerts(nullptr);
  data->SetPolys(polygons);
  data->SetLines(lines);
  number<vtkDoubleArray>(*data->GetPointData(), "Number", 8);
  number<vtkIdTypeArray>(*data->GetCellData(), "Cell", 5);
  return data;
}

std::vector<double> valuesOf(vtkDataArray* array)
{
  std::vector<double> values;
  for (vtkIdType i = 0; array != nullptr && i < array->GetNumberOfTuples(); ++i)
  {
    values.push_back(array->GetTuple1(i));
  }
  return values;
}

template <class Filter>
vtkNew<Filter> ran(vtkPolyData* input, const std::string& region)
{
  vtkNew<Filter> filter;
  filter->SetInputData(input);
  filter->SetRegion(region);
  filter->Update();
  EXPECT_EQ(filter->GetOutcome().state, State::ok) << filter->GetOutcome().message;
  return filter;
}

vtkSmartPointer<vtkPolyData> selected(
  vtkPolyData* input, const std::string& name, const std::string& rule)
{
  vtkNew<vtkScanSelectFilter> select;
  select->SetInputData(input);
  select->SetName(name);
  select->SetRule(rule);
  select->Update();
  EXPECT_EQ(select->GetOutcome().state, State::ok) << select->GetOutcome().message;
  return select->GetOutput();
}

vtkSmartPointer<vtkPolyData> wrapped(vtkPolyData* input)
{
  vtkNew<vtkScanWrapFilter> wrap;
  wrap->SetInputData(input);
  wrap->SetMode(vtkScanWrapFilter::CLASSIC);
  wrap->Update();
  EXPECT_EQ(wrap->GetOutcome().state, State::ok) << wrap->GetOutcome().message;
  return wrap->GetOutput();
}

std::string ruleOf(vtkDataObject& data, const std::string& name)
{
  return textOf(bridge::regionsOf(data).at(name));
}

TEST(SelectFilter, StoresTheRuleAndLeavesItsInputAlone)
{
  const auto scan = sphere(200);
  const auto one = selected(scan, "top", "plane(0,0,0, 0,0,1)");
  const auto two = selected(one, "part", "top & !box(0,0,0, 1,1,1)");
  const auto three = selected(two, "top", "none");
  EXPECT_TRUE(bridge::regionsOf(*scan).empty());
  EXPECT_EQ(bridge::regionsOf(*one).size(), 1U);
  EXPECT_EQ(ruleOf(*one, "top"), "plane(0,0,0,0,0,1)");
  EXPECT_EQ(ruleOf(*two, "part"), "plane(0,0,0,0,0,1) & !box(0,0,0,1,1,1)");
  EXPECT_EQ(ruleOf(*two, "top"), "plane(0,0,0,0,0,1)");
  EXPECT_EQ(ruleOf(*three, "top"), "none");
  EXPECT_EQ(ruleOf(*three, "part"), ruleOf(*two, "part")); // as it was when part was chosen
  EXPECT_EQ(three->GetPoints(), scan->GetPoints());
  EXPECT_EQ(bridge::unitOf(*three), 25.4);
}

TEST(SelectFilter, CountsWhatIsInTheRegion)
{
  const auto data = patches();
  vtkNew<vtkScanSelectFilter> select;
  select->SetInputData(data);
  select->SetName("lower");
  select->SetRule("plane(0,0,0, 0,-1,0)");
  select->Update();
  EXPECT_EQ(select->GetTriangles(), 2);
  EXPECT_EQ(select->GetPoints(), 4);
  EXPECT_EQ(select->GetShare(), 0.4);
  EXPECT_EQ(select->GetNote(), "");
  select->SetRule("sphere(9,9,9, 1)");
  select->Update();
  EXPECT_EQ(select->GetShare(), 0.0);
  EXPECT_EQ(select->GetNote(), "nothing is in the region lower");
}

TEST(SelectFilter, RefusesNamesAndRulesThatAreNone)
{
  const auto data = patches();
  for (const auto& [name, rule] : std::vector<std::pair<std::string, std::string>>{ { "", "all" },
         { "box", "all" }, { "a b", "all" }, { "a", "" }, { "a", "box(" }, { "a", "points(0)" },
         { "a", "deviation(0,1)" } })
  {
    vtkNew<vtkScanSelectFilter> select;
    select->SetInputData(data);
    select->SetName(name);
    select->SetRule(rule);
    select->GetExecutive()->Update();
    EXPECT_EQ(select->GetOutcome().state, State::failed) << name << " " << rule;
    EXPECT_EQ(select->GetOutcome().code, ErrorCode::badParameter) << name << " " << rule;
  }
}

TEST(SelectFilter, AWrapStaysAWrapAndKeepsItsRegions)
{
  const auto wrap = wrapped(selected(sphere(300), "top", "plane(0,0,0.5, 0,0,1)"));
  EXPECT_EQ(ruleOf(*wrap, "top"), "plane(0,0,0.5,0,0,1)");
  const auto named = selected(wrap, "side", "plane(0,0,0, 1,0,0)");
  ASSERT_TRUE(named->IsA("vtkScanWrapData"));
  vtkNew<vtkScanPushFilter> push;
  push->SetInputData(named);
  push->AddTriangle(0);
  push->Update();
  EXPECT_EQ(push->GetOutcome().state, State::ok) << push->GetOutcome().message;
  EXPECT_EQ(bridge::regionsOf(*push->GetOutput()).size(), 2U);
}

TEST(CropFilter, KeepsTrianglesWithTheirDataAndThePointsTheyUse)
{
  const auto data = patches();
  const auto upper = ran<vtkScanCropFilter>(data, "plane(0,0,0, 0,1,0)");
  vtkPolyData& output = *upper->GetOutput();
  EXPECT_EQ(bridge::meshOf(output).triangles,
    (std::vector<Triangle>{ { 0, 1, 2 }, { 0, 2, 3 }, { 1, 4, 2 } }));
  EXPECT_EQ(
    valuesOf(output.GetPointData()->GetArray("Number")), (std::vector<double>{ 0, 1, 2, 3, 4 }));
  EXPECT_EQ(valuesOf(output.GetCellData()->GetArray("Cell")), // the curve 0, then polygons 2, 3
    (std::vector<double>{ 0, 2, 2, 3 }));
  EXPECT_EQ(output.GetNumberOfLines(), 1);
  EXPECT_EQ(upper->GetTrianglesGone(), 2);
  EXPECT_EQ(upper->GetPointsGone(), 3);
  EXPECT_EQ(bridge::unitOf(output), 25.4);

  vtkNew<vtkScanCropFilter> erase;
  erase->SetInputData(data);
  erase->SetRegion("plane(0,0,0, 0,1,0)");
  erase->EraseOn();
  erase->Update();
  EXPECT_EQ(bridge::meshOf(*erase->GetOutput()).triangles.size(), 2U);
  EXPECT_EQ(bridge::scanPointIdsOf(*erase->GetOutput()), (std::vector<vtkIdType>{ 0, 1, 5, 6 }));
  EXPECT_EQ(erase->GetOutput()->GetNumberOfLines(), 0);
}

TEST(CropFilter, KeepsPointsOfAScan)
{
  const auto scan = selected(sphere(500), "top", "plane(0,0,0, 0,0,1)");
  const auto crop = ran<vtkScanCropFilter>(scan, "top");
  const std::vector<Vec3> kept = bridge::pointsOf(*crop->GetOutput());
  EXPECT_GT(kept.size(), 200U);
  EXPECT_TRUE(std::ranges::all_of(kept, [](const Vec3& p) { return p.z >= 0.0; }));
  EXPECT_EQ(crop->GetOutput()->GetNumberOfVerts(), static_cast<vtkIdType>(kept.size()));
  EXPECT_EQ(ruleOf(*crop->GetOutput(), "top"), "plane(0,0,0,0,0,1)");
  EXPECT_EQ(ran<vtkScanCropFilter>(scan, "all")->GetNote(), "nothing changed");
  EXPECT_EQ(ran<vtkScanCropFilter>(scan, "none")->GetNote(), "nothing is left");
}

TEST(CropFilter, ArraysOfCellsAndPointsChooseTriangles)
{
  const auto data = patches();
  const auto counted = [&](const std::string& rule)
  { return bridge::meshOf(*ran<vtkScanCropFilter>(data, rule)->GetOutput()).triangles.size(); };
  EXPECT_EQ(counted("array(Cell, 2, 2)"), 2U);
  EXPECT_EQ(counted("array(Number, 2.1, 9)"), 2U); // 7/3 of the single triangle, 4 of one below
  vtkNew<vtkScanCropFilter> crop;
  crop->SetInputData(data);
  crop->SetRegion("deviation(0, 1)");
  crop->GetExecutive()->Update();
  EXPECT_EQ(
    crop->GetOutcome().message, "region: the model has no array Deviation; it has Number, Cell");
}

TEST(CropFilter, NamesTheRegionsThereAre)
{
  const auto scan = selected(selected(sphere(50), "top", "all"), "low", "none");
  vtkNew<vtkScanCropFilter> crop;
  crop->SetInputData(scan);
  crop->GetExecutive()->Update();
  EXPECT_EQ(crop->GetOutcome().code, ErrorCode::badParameter);
  EXPECT_EQ(crop->GetOutcome().message.find("--region: expected the name of a region"), 0U);
  crop->SetRegion("left");
  crop->GetExecutive()->Update();
  EXPECT_EQ(crop->GetOutcome().code, ErrorCode::badParameter);
  EXPECT_NE(crop->GetOutcome().message.find("regions low, top, found"), std::string::npos)
    << crop->GetOutcome().message;
}

TEST(InfoFilter, MeasuresTheRegionAndPassesAllOn)
{
  const auto data = patches();
  const auto info = ran<vtkScanInfoFilter>(data, "plane(0,0,0, 0,-1,0)");
  EXPECT_EQ(info->GetReport().triangles, 2U);
  EXPECT_EQ(info->GetReport().area, 1.0);
  EXPECT_EQ(info->GetMillimetresPerUnit(), 25.4);
  EXPECT_EQ(info->GetOutput()->GetNumberOfPolys(), 3);
}

TEST(WrapFilter, WrapsThePointsOfTheRegion)
{
  const auto hollow = sphere(600); // with points inside, which are not on its surface
  for (vtkIdType i = 0; i < 600; i += 3)
  {
    hollow->GetPoints()->InsertNextPoint(
      0.5 * hollow->GetPoint(i)[0], 0.5 * hollow->GetPoint(i)[1], 0.5 * hollow->GetPoint(i)[2]);
  }
  const auto scan = selected(hollow, "top", "plane(0,0,-0.2, 0,0,1)");
  const auto whole = wrapped(ran<vtkScanCropFilter>(scan, "top")->GetOutput());
  const auto region = ran<vtkScanWrapFilter>(scan, "top");
  EXPECT_LT(region->GetReport().pointsRead, 600U);
  EXPECT_EQ(bridge::scanPointIdsOf(*whole),
    [&]
    {
      vtkNew<vtkScanWrapFilter> wrap;
      wrap->SetInputData(wrapped(scan)); // the scan behind a wrap
      wrap->SetMode(vtkScanWrapFilter::CLASSIC);
      wrap->SetRegion("top");
      wrap->Update();
      EXPECT_EQ(bridge::meshOf(*wrap->GetOutput()).triangles, bridge::meshOf(*whole).triangles);
      return bridge::scanPointIdsOf(*wrap->GetOutput());
    }());
}

TEST(WrapEditFilter, TheTrianglesOfTheRegionAreMarks)
{
  const auto wrap = selected(wrapped(tube()), "part", "sphere(0,0,0, 0.7)"); // across its end
  const auto byRegion = ran<vtkScanPushFilter>(wrap, "part");
  vtkNew<vtkScanPushFilter> byNumber;
  byNumber->SetInputData(wrap);
  Execution execution;
  const std::vector<std::uint8_t> isInside = bridge::trianglesInRegion(*wrap, "part", execution);
  for (std::size_t t = 0; t < isInside.size(); ++t)
  {
    if (isInside[t] != 0)
    {
      byNumber->AddTriangle(static_cast<vtkIdType>(t));
    }
  }
  byNumber->Update();
  EXPECT_GT(byRegion->GetReport().Marks, 1U);
  EXPECT_EQ(byRegion->GetReport().Marks, byNumber->GetReport().Marks);
  EXPECT_EQ(bridge::meshOf(*byRegion->GetOutput()).triangles,
    bridge::meshOf(*byNumber->GetOutput()).triangles);
  EXPECT_NE(bridge::meshOf(*byRegion->GetOutput()).triangles, bridge::meshOf(*wrap).triangles);
}

TEST(WrapEditFilter, ARegionWithNothingInItIsNowhere)
{
  // slivers stay on the quads of a grid
  TriMesh grid;
  for (int i = 0; i < 12; ++i)
  {
    for (int j = 0; j < 12; ++j)
    {
      grid.points.push_back({ 1.0 * i, 1.0 * j, i * j % 5 == 0 ? 0.3 : 0.0 });
    }
  }
  const auto wrap = wrapped(dataOf(grid));
  const auto everywhere = ran<vtkScanFlattenFilter>(wrap, "");
  const auto nowhere = ran<vtkScanFlattenFilter>(wrap, "none");
  EXPECT_NE(bridge::meshOf(*everywhere->GetOutput()).triangles, bridge::meshOf(*wrap).triangles);
  EXPECT_EQ(bridge::meshOf(*nowhere->GetOutput()).triangles, bridge::meshOf(*wrap).triangles);
  EXPECT_EQ(nowhere->GetReport().Marks, 0U);
}

} // namespace
