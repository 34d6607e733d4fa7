// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/analysis/cloud_normals.h"

#include <vtkIdList.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkStaticPointLocator.h>

#include <algorithm>
#include <array>

namespace scan
{
namespace
{

/// Points that suggest a plane.
constexpr int kNeighbours = 12;

constexpr std::size_t kGrain = 1U << 12U;
constexpr std::size_t kStep = 1U << 16U;

Vec3 pointOf(vtkPolyData& cloud, vtkIdType id)
{
  std::array<double, 3> p{};
  cloud.GetPoints()->GetPoint(id, p.data()); // safe on many threads
  return { p[0], p[1], p[2] };
}

/// The direction in which the points spread least.
Vec3 planeNormal(vtkPolyData& cloud, vtkIdList& points)
{
  const vtkIdType count = points.GetNumberOfIds();
  Vec3 mean;
  for (vtkIdType i = 0; i < count; ++i)
  {
    mean = mean + pointOf(cloud, points.GetId(i)) * (1.0 / static_cast<double>(count));
  }
  std::array<std::array<double, 3>, 3> spread{};
  for (vtkIdType i = 0; i < count; ++i)
  {
    const Vec3 d = pointOf(cloud, points.GetId(i)) - mean;
    const std::array<double, 3> v = { d.x, d.y, d.z };
    for (std::size_t row = 0; row < 3; ++row)
    {
      for (std::size_t column = 0; column < 3; ++column)
      {
        spread[row][column] += v[row] * v[column];
      }
    }
  }
  std::array<double*, 3> rows = { spread[0].data(), spread[1].data(), spread[2].data() };
  std::array<std::array<double, 3>, 3> vectors{};
  std::array<double*, 3> vectorRows = { vectors[0].data(), vectors[1].data(), vectors[2].data() };
  std::array<double, 3> values{};
  vtkMath::Jacobi(rows.data(), values.data(), vectorRows.data()); // values fall
  return { vectors[0][2], vectors[1][2], vectors[2][2] };
}

} // namespace

vtkSmartPointer<vtkFloatArray> cloudNormals(
  vtkPolyData& cloud, const Vec3& eye, Execution& execution)
{
  const auto count = static_cast<std::size_t>(cloud.GetNumberOfPoints());
  execution.step("shade", 0, count);
  vtkNew<vtkStaticPointLocator> locator;
  locator->SetDataSet(&cloud);
  locator->BuildLocator();

  auto normals = vtkSmartPointer<vtkFloatArray>::New();
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(static_cast<vtkIdType>(count));
  float* const values = normals->GetPointer(0);
  for (std::size_t first = 0; first < count; first += kStep)
  {
    execution.step("shade", first, count);
    execution.parallelFor(std::min(kStep, count - first), kGrain,
      [&](std::size_t begin, std::size_t end)
      {
        vtkNew<vtkIdList> nearest;
        for (std::size_t i = first + begin; i < first + end; ++i)
        {
          const Vec3 p = pointOf(cloud, static_cast<vtkIdType>(i));
          const std::array<double, 3> x = { p.x, p.y, p.z };
          locator->FindClosestNPoints(kNeighbours, x.data(), nearest);
          Vec3 normal = planeNormal(cloud, *nearest);
          normal = dot(normal, eye - p) < 0.0 ? normal * -1.0 : normal;
          values[3 * i] = static_cast<float>(normal.x);
          values[3 * i + 1] = static_cast<float>(normal.y);
          values[3 * i + 2] = static_cast<float>(normal.z);
        }
      });
  }
  execution.step("shade", count, count);
  return normals;
}

} // namespace scan
