// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/base/vtkScanArrayNames.h"
#include "filters/base/vtkScanMeshBridge.h"
#include "filters/points/vtkScanAddPointsFilter.h"
#include "filters/points/vtkScanAlignFilter.h"
#include "filters/points/vtkScanDenoiseFilter.h"
#include "filters/points/vtkScanNormalsFilter.h"
#include "filters/points/vtkScanRemoveOutliersFilter.h"
#include "filters/points/vtkScanThinFilter.h"
#include "filters/wrap/vtkScanWrapFilter.h"

#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSphereSource.h>
#include <vtkStringArray.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

using scan::Index;
using scan::Vec3;

namespace
{

/// A triangulated sphere of 482 points with colours, normals and values of its own.
vtkSmartPointer<vtkPolyData> sphere()
{
  vtkNew<vtkSphereSource> source;
  source->SetThetaResolution(24);
  source->SetPhiResolution(22);
  source->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  source->Update();
  vtkSmartPointer<vtkPolyData> data = source->GetOutput();
  scan::Model model = scan::bridge::modelOf(*data);
  model.millimetresPerUnit = 25.4;
  for (std::size_t i = 0; i < model.points.size(); ++i)
  {
    model.colors.push_back({ static_cast<std::uint8_t>(i % 200), 1, 2 });
  }
  scan::bridge::setModel(*data, model);
  vtkNew<vtkDoubleArray> quality;
  quality->SetName("quality");
  for (std::size_t i = 0; i < model.points.size(); ++i)
  {
    quality->InsertNextValue(1000.0 + static_cast<double>(i));
  }
  data->GetPointData()->AddArray(quality);
  return data;
}

vtkSmartPointer<vtkPolyData> scanOf(vtkPolyData& mesh)
{
  auto scan = vtkSmartPointer<vtkPolyData>::New();
  scan::bridge::setMesh(*scan, { scan::bridge::pointsOf(mesh), {} });
  scan->GetPointData()->ShallowCopy(mesh.GetPointData());
  return scan;
}

template <class Filter>
vtkPolyData& outputOf(Filter& filter, vtkPolyData& input)
{
  filter.SetInputData(&input);
  filter.Update();
  EXPECT_EQ(filter.GetOutcome().state, vtkScanOutcome::State::ok) << filter.GetOutcome().message;
  return *filter.GetOutput();
}

double valueAt(vtkPolyData& data, const char* name, vtkIdType point, int component = 0)
{
  return data.GetPointData()->GetArray(name)->GetComponent(point, component);
}

void expectKeptPointsAreTheOldOnes(vtkPolyData& input, vtkPolyData& output)
{
  const std::vector<vtkIdType> ids = scan::bridge::scanPointIdsOf(output);
  const std::vector<Vec3> before = scan::bridge::pointsOf(input);
  const std::vector<Vec3> after = scan::bridge::pointsOf(output);
  for (vtkIdType i = 0; i < output.GetNumberOfPoints(); ++i)
  {
    const vtkIdType id = ids[static_cast<std::size_t>(i)];
    EXPECT_EQ(after[static_cast<std::size_t>(i)], before[static_cast<std::size_t>(id)]);
    EXPECT_EQ(valueAt(output, "quality", i), 1000.0 + static_cast<double>(id));
    EXPECT_EQ(valueAt(output, scan::arrays::kColors, i), static_cast<double>(id % 200));
  }
}

} // namespace

TEST(ThinFilter, KeepsPointsWithTheirDataAndCellsThatLoseNone)
{
  const auto mesh = sphere();
  vtkNew<vtkScanThinFilter> filter;
  filter->SetBy(scan::ThinOptions::By::random);
  filter->SetKeep(90.0);
  vtkPolyData& output = outputOf(*filter, *mesh);
  EXPECT_EQ(filter->GetPointsAfter(), output.GetNumberOfPoints());
  EXPECT_EQ(
    output.GetNumberOfPoints(), std::lround(0.9 * static_cast<double>(mesh->GetNumberOfPoints())));
  EXPECT_GT(output.GetNumberOfPolys(), 0);
  EXPECT_LT(output.GetNumberOfPolys(), mesh->GetNumberOfPolys());
  EXPECT_EQ(output.GetNumberOfVerts(), 0);
  EXPECT_EQ(scan::bridge::unitOf(output), 25.4);
  expectKeptPointsAreTheOldOnes(*mesh, output);

  vtkNew<vtkScanThinFilter> ofScan;
  const auto scan = scanOf(*mesh);
  vtkPolyData& thinner = outputOf(*ofScan, *scan);
  EXPECT_LT(thinner.GetNumberOfPoints(), scan->GetNumberOfPoints() / 2);
  EXPECT_EQ(thinner.GetNumberOfVerts(), thinner.GetNumberOfPoints());
}

TEST(RemoveOutliersFilter, RemovesAStrayPointAndItsTriangle)
{
  const auto data = sphere();
  const vtkIdType last = data->GetNumberOfPoints() - 1;
  data->GetPoints()->SetPoint(last, 9, 9, 9);
  vtkNew<vtkScanRemoveOutliersFilter> filter;
  vtkPolyData& output = outputOf(*filter, *data);
  EXPECT_EQ(output.GetNumberOfPoints(), last);
  EXPECT_LT(output.GetNumberOfPolys(), data->GetNumberOfPolys());
  expectKeptPointsAreTheOldOnes(*data, output);
  EXPECT_TRUE(filter->GetNote().empty());
  vtkNew<vtkScanRemoveOutliersFilter> again;
  outputOf(*again, output);
  EXPECT_EQ(again->GetNote(), "no stray points found");
}

TEST(DenoiseFilter, MovesPointsOfAMeshAndKeepsTheRest)
{
  const auto data = sphere();
  data->GetPoints()->SetPoint(100, 0.0, 0.0, 0.0);
  vtkNew<vtkScanDenoiseFilter> filter;
  filter->SetMaxShift(scan::Length(0.125));
  vtkPolyData& output = outputOf(*filter, *data);
  EXPECT_EQ(output.GetNumberOfPolys(), data->GetNumberOfPolys());
  EXPECT_EQ(filter->GetLimit(), 0.125);
  EXPECT_LE(filter->GetResult().largestShift, 0.125);
  EXPECT_GT(filter->GetResult().moved, 0U);
  EXPECT_EQ(valueAt(output, "quality", 100), 1100.0);
  EXPECT_NE(output.GetPointData()->GetNormals(), nullptr);
}

TEST(NormalsFilter, SetsTheActiveNormals)
{
  const auto data = scanOf(*sphere());
  data->GetPointData()->SetNormals(nullptr);
  vtkNew<vtkScanNormalsFilter> filter;
  vtkPolyData& output = outputOf(*filter, *data);
  const std::vector<Vec3> normals = scan::bridge::normalsOf(output);
  const std::vector<Vec3> points = scan::bridge::pointsOf(output);
  ASSERT_EQ(normals.size(), points.size());
  EXPECT_STREQ(output.GetPointData()->GetNormals()->GetName(), scan::arrays::kNormals);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    EXPECT_GT(scan::dot(normals[i], points[i]), 0.4); // of 0.5
  }
}

TEST(AddPointsFilter, AddsBehindTheLargestId)
{
  const auto mesh = sphere();
  vtkNew<vtkScanThinFilter> thin;
  thin->SetBy(scan::ThinOptions::By::random);
  vtkPolyData& thinned = outputOf(*thin, *scanOf(*mesh));
  const vtkIdType before = thinned.GetNumberOfPoints();
  const std::vector<vtkIdType> ids = scan::bridge::scanPointIdsOf(thinned);

  vtkNew<vtkScanAddPointsFilter> filter;
  filter->AddPoint(1, 2, 3);
  filter->AddPoint(4, 5, 6);
  filter->SetDepth(vtkScanAddPointsFilter::Y, -7.5);
  vtkPolyData& output = outputOf(*filter, thinned);
  EXPECT_EQ(output.GetNumberOfPoints(), before + 2);
  EXPECT_EQ(output.GetNumberOfVerts(), before + 2);
  const std::vector<Vec3> points = scan::bridge::pointsOf(output);
  EXPECT_EQ(points[points.size() - 2], (Vec3{ 1, -7.5, 3 }));
  EXPECT_EQ(points.back(), (Vec3{ 4, -7.5, 6 }));
  const std::vector<vtkIdType> idsAfter = scan::bridge::scanPointIdsOf(output);
  EXPECT_EQ(idsAfter.back(), *std::ranges::max_element(ids) + 2);
  EXPECT_TRUE(std::equal(ids.begin(), ids.end(), idsAfter.begin()));
  expectKeptPointsAreTheOldOnes(*mesh, thinned);
  for (int component = 0; component < 3; ++component)
  {
    EXPECT_EQ(valueAt(output, scan::arrays::kColors, before, component), 255.0);
    EXPECT_EQ(valueAt(output, scan::arrays::kNormals, before, component), 0.0);
    EXPECT_EQ(valueAt(output, scan::arrays::kColors, 0, component),
      valueAt(thinned, scan::arrays::kColors, 0, component));
  }
  EXPECT_EQ(valueAt(output, "quality", before), 0.0);
}

TEST(AddPointsFilter, OfAWrapGivesAPlainModelThatCanBeWrappedAgain)
{
  vtkNew<vtkScanWrapFilter> wrap;
  vtkPolyData& surface = outputOf(*wrap, *scanOf(*sphere()));
  vtkNew<vtkScanAddPointsFilter> filter;
  filter->AddPoint(0, 0, 0.7);
  vtkPolyData& output = outputOf(*filter, surface);
  EXPECT_STREQ(output.GetClassName(), "vtkPolyData");
  EXPECT_EQ(output.GetNumberOfPolys(), surface.GetNumberOfPolys());
  vtkNew<vtkScanWrapFilter> again;
  EXPECT_EQ(outputOf(*again, output).GetNumberOfPoints(), surface.GetNumberOfPoints() + 1);
}

TEST(AlignFilter, MovesOneFileAndItsNormals)
{
  // an ellipsoid, half of it moved
  scan::Model model = scan::bridge::modelOf(*sphere());
  const auto half = static_cast<vtkIdType>(model.points.size());
  for (std::size_t i = 0; i < model.points.size(); ++i)
  {
    model.points[i] = { model.points[i].x, 1.5 * model.points[i].y, 2.0 * model.points[i].z };
  }
  scan::Affine off = scan::rotationBy(0.0, 0.0, 0.02, 1.0);
  off.origin = { 0.01, 0.02, 0.0 };
  const std::vector<Vec3> target = model.points;
  const std::vector<Vec3> normals = model.normals;
  for (std::size_t i = 0; i < target.size(); ++i)
  {
    model.points.push_back(off.point(target[i]));
    model.normals.push_back(off.normal(normals[i]));
  }
  model.colors.clear();
  model.triangles.clear();
  vtkNew<vtkPolyData> data;
  scan::bridge::setModel(*data, model);
  vtkNew<vtkStringArray> names;
  names->SetName(scan::arrays::kScanFileNames);
  names->InsertNextValue("fixed.ply");
  names->InsertNextValue("moving.ply");
  vtkNew<vtkIdTypeArray> ends;
  ends->SetName(scan::arrays::kScanFileEnds);
  ends->InsertNextValue(half);
  ends->InsertNextValue(2 * half);
  data->GetFieldData()->AddArray(names);
  data->GetFieldData()->AddArray(ends);

  for (const char* const scan : { "", "2", "moving.ply" })
  {
    vtkNew<vtkScanAlignFilter> filter;
    filter->SetScan(scan);
    vtkPolyData& output = outputOf(*filter, *data);
    const std::vector<Vec3> points = scan::bridge::pointsOf(output);
    const std::vector<Vec3> turned = scan::bridge::normalsOf(output);
    for (std::size_t i = 0; i < target.size(); ++i)
    {
      EXPECT_EQ(points[i], target[i]);
      EXPECT_LT(
        scan::dot(points[target.size() + i] - target[i], points[target.size() + i] - target[i]),
        1e-16);
      EXPECT_GT(scan::dot(turned[target.size() + i], normals[i]), 1.0 - 1e-6);
    }
    EXPECT_EQ(scan::bridge::scanFilesOf(output).size(), 2U);
    EXPECT_EQ(filter->GetFileName(), "moving.ply");
  }
  vtkNew<vtkScanAlignFilter> wrong;
  wrong->SetScan("3");
  wrong->SetInputData(data);
  wrong->SetGlobalWarningDisplay(0);
  wrong->Update();
  wrong->SetGlobalWarningDisplay(1);
  EXPECT_EQ(wrong->GetOutcome().code, scan::ErrorCode::badParameter);
  EXPECT_NE(wrong->GetOutcome().message.find("1 fixed.ply, 2 moving.ply"), std::string::npos);
}

TEST(PointFilters, RefuseARegionThatIsNotThere)
{
  const auto data = scanOf(*sphere());
  const auto expectRefused = [&](auto& filter)
  {
    filter.SetRegion("nowhere");
    filter.SetInputData(data);
    filter.SetGlobalWarningDisplay(0);
    filter.Update();
    filter.SetGlobalWarningDisplay(1);
    EXPECT_EQ(filter.GetOutcome().code, scan::ErrorCode::badParameter) << filter.GetClassName();
    EXPECT_EQ(filter.GetOutput()->GetNumberOfPoints(), 0);
  };
  expectRefused(*vtkSmartPointer<vtkScanThinFilter>::New());
  expectRefused(*vtkSmartPointer<vtkScanRemoveOutliersFilter>::New());
  expectRefused(*vtkSmartPointer<vtkScanDenoiseFilter>::New());
  expectRefused(*vtkSmartPointer<vtkScanNormalsFilter>::New());
}
