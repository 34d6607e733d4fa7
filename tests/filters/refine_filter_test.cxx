// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/base/vtkScanArrayNames.h"
#include "filters/base/vtkScanMeshBridge.h"
#include "filters/surface/vtkScanRefineFilter.h"
#include "tests/geometry/mesh_corpus.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <gtest/gtest.h>

#include <string>

namespace
{

/// A torus whose points have a value, the x coordinate, and whose triangles have their number.
vtkSmartPointer<vtkPolyData> torus()
{
  const scan::TriMesh mesh = corpus::torus(12);
  auto data = vtkSmartPointer<vtkPolyData>::New();
  scan::bridge::setMesh(*data, mesh);
  vtkNew<vtkDoubleArray> x;
  x->SetName("x");
  for (const scan::Vec3& p : mesh.points)
  {
    x->InsertNextValue(p.x);
  }
  data->GetPointData()->AddArray(x);
  vtkNew<vtkDoubleArray> number;
  number->SetName("number");
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    number->InsertNextValue(static_cast<double>(t));
  }
  data->GetCellData()->AddArray(number);
  return data;
}

vtkSmartPointer<vtkPolyData> refined(vtkPolyData& input, vtkScanRefineFilter& filter)
{
  filter.SetInputData(&input);
  filter.Update();
  EXPECT_EQ(filter.GetOutcome().state, vtkScanOutcome::State::ok) << filter.GetOutcome().message;
  return filter.GetOutput();
}

TEST(RefineFilter, KeepsTheDataAndTheMarksOfHalves)
{
  const auto input = torus();
  vtkNew<vtkScanRefineFilter> first;
  first->SetMode(vtkScanRefineFilter::Mode::midpoint);
  first->SetRegion("sphere(3,0,0,1)");
  const auto once = refined(*input, *first);
  const vtkIdType count = once->GetNumberOfPolys();
  EXPECT_GT(count, input->GetNumberOfPolys());
  EXPECT_EQ(first->GetPointsAdded(), once->GetNumberOfPoints() - input->GetNumberOfPoints());
  EXPECT_LT(first->GetDeviation()->largest, 1e-12);
  vtkDataArray* const halves = once->GetCellData()->GetArray(scan::arrays::kHalf);
  ASSERT_NE(halves, nullptr);
  EXPECT_EQ(halves->GetNumberOfTuples(), count);
  EXPECT_EQ(once->GetCellData()->GetArray("number")->GetNumberOfTuples(), count);
  for (vtkIdType i = 0; i < once->GetNumberOfPoints(); ++i)
  {
    EXPECT_NEAR(
      once->GetPointData()->GetArray("x")->GetComponent(i, 0), once->GetPoint(i)[0], 1e-12);
    EXPECT_EQ(once->GetPointData()->GetArray(scan::arrays::kScanPointId)->GetComponent(i, 0),
      i < input->GetNumberOfPoints() ? static_cast<double>(i) : -1.0);
  }

  vtkNew<vtkScanRefineFilter> second;
  second->SetRegion("sphere(3,0,0,1.5)");
  const auto twice = refined(*once, *second);
  EXPECT_GT(second->GetResult().joined, 0U);
  EXPECT_EQ(twice->GetCellData()->GetArray(scan::arrays::kHalf)->GetNumberOfTuples(),
    twice->GetNumberOfPolys());
}

TEST(RefineFilter, WholeTrianglesHaveNoMarks)
{
  const auto input = torus();
  vtkNew<vtkScanRefineFilter> filter;
  const auto output = refined(*input, *filter);
  EXPECT_EQ(output->GetNumberOfPolys(), 4 * input->GetNumberOfPolys());
  EXPECT_EQ(output->GetCellData()->GetArray(scan::arrays::kHalf), nullptr);
}

TEST(RefineFilter, StaysWithinTheDeviation)
{
  const auto input = torus();
  vtkNew<vtkScanRefineFilter> free;
  refined(*input, *free);
  const double wanted = free->GetDeviation()->largest;
  vtkNew<vtkScanRefineFilter> filter;
  filter->SetTimes(2);
  filter->SetMaxDeviation(scan::Length(0.25 * wanted));
  refined(*input, *filter);
  EXPECT_GT(filter->GetResult().heldBack, 0U);
  EXPECT_LE(filter->GetDeviation()->largest, 0.25 * wanted);
  EXPECT_GT(filter->GetDeviation()->largest, 0.2 * wanted);
}

} // namespace
