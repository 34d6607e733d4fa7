// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/comparison.h"

#include "filters/base/vtkScanMeshBridge.h"
#include "filters/geometry/surface_change.h"
#include "filters/wrap/vtkScanWrapData.h"
#include "pipeline/form_hash.h"

#include <vtkGenericCell.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkStaticCellLocator.h>
#include <vtkStaticPointLocator.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

namespace scan
{

namespace
{

constexpr std::size_t kMostPoints = 20000;

/// The distances of points to a model.
class DistanceTo
{
public:
  explicit DistanceTo(vtkPolyData& model)
    : IsSurface(bridge::hasTriangles(model))
  {
    if (this->IsSurface)
    {
      this->Surface->ShallowCopy(&model);
      this->Surface->SetVerts(nullptr);
      this->Surface->SetLines(nullptr);
      this->Cells->SetDataSet(this->Surface);
      this->Cells->BuildLocator();
    }
    else
    {
      this->Surface->SetPoints(model.GetPoints());
      this->Points->SetDataSet(this->Surface);
      this->Points->BuildLocator();
    }
  }

  double operator()(const Vec3& point)
  {
    const std::array<double, 3> p{ point.x, point.y, point.z };
    std::array<double, 3> nearest{};
    double squared = 0.0;
    if (this->IsSurface)
    {
      vtkIdType cell = 0;
      int part = 0;
      this->Cells->FindClosestPoint(p.data(), nearest.data(), this->Cell, cell, part, squared);
      return std::sqrt(squared);
    }
    this->Surface->GetPoint(this->Points->FindClosestPoint(p.data()), nearest.data());
    return std::sqrt(vtkMath::Distance2BetweenPoints(p.data(), nearest.data()));
  }

private:
  bool IsSurface;
  vtkNew<vtkPolyData> Surface;
  vtkNew<vtkStaticCellLocator> Cells;
  vtkNew<vtkStaticPointLocator> Points;
  vtkNew<vtkGenericCell> Cell;
};

void addDeviation(const std::string& name, vtkPolyData& from, vtkPolyData& to, Execution& execution,
  Results& results)
{
  const std::vector<Vec3> points = bridge::pointsOf(from);
  if (points.empty() || to.GetNumberOfPoints() == 0)
  {
    results.emplace_back("deviation-" + name, std::monostate());
    return;
  }
  DistanceTo distanceTo(to);
  const std::size_t count = std::min(points.size(), kMostPoints);
  double sum = 0.0;
  double squares = 0.0;
  double largest = 0.0;
  for (std::size_t i = 0; i < count; ++i)
  {
    const double distance = distanceTo(points[i * points.size() / count]);
    sum += distance;
    squares += distance * distance;
    largest = std::max(largest, distance);
    execution.step("compare", i, count);
  }
  const auto n = static_cast<double>(count);
  results.emplace_back("points-measured-" + name, static_cast<std::int64_t>(count));
  results.emplace_back("mean-deviation-" + name, sum / n);
  results.emplace_back("rms-deviation-" + name, std::sqrt(squares / n));
  results.emplace_back("largest-deviation-" + name, largest);
}

/// What edits of the same complex changed.
void addWrapChange(vtkPolyData& a, vtkPolyData& b, Execution& execution, Results& results)
{
  const auto* const first = vtkScanWrapData::SafeDownCast(&a);
  const auto* const second = vtkScanWrapData::SafeDownCast(&b);
  if (first == nullptr || second == nullptr || first->GetModel().scan != second->GetModel().scan)
  {
    return;
  }
  const SurfaceChange change =
    compareSurfaces(*first->GetModel().current, *second->GetModel().current, execution);
  results.emplace_back("triangles-gone", static_cast<std::int64_t>(change.gone.size()));
  results.emplace_back("triangles-new", static_cast<std::int64_t>(change.added.size()));
}

} // namespace

Comparison compare(Document& document, StepId a, StepId b, const RunOptions& options)
{
  Comparison comparison{ .a = a, .b = b };
  const std::vector<StepId> pathA = document.pathTo(a);
  const std::vector<StepId> pathB = document.pathTo(b);
  const auto [endA, endB] = std::ranges::mismatch(pathA, pathB);
  comparison.common = endA != pathA.begin() ? *(endA - 1) : 0;
  comparison.onlyA.assign(endA, pathA.end());
  comparison.onlyB.assign(endB, pathB.end());

  const vtkSmartPointer<vtkPolyData> modelA = document.result(a, options);
  const vtkSmartPointer<vtkPolyData> modelB = document.result(b, options);
  Execution execution(options.threads, options.token, options.progress);
  execution.plan({ { "compare", 1.0 } });
  comparison.isSame =
    hashesOf(formOf(*modelA), execution).form == hashesOf(formOf(*modelB), execution).form;
  Results& measures = comparison.measures;
  measures = {
    { "same", comparison.isSame },
    { "points-a", std::int64_t{ modelA->GetNumberOfPoints() } },
    { "points-b", std::int64_t{ modelB->GetNumberOfPoints() } },
    { "triangles-a", std::int64_t{ modelA->GetNumberOfPolys() } },
    { "triangles-b", std::int64_t{ modelB->GetNumberOfPolys() } },
  };
  if (!comparison.isSame)
  {
    addWrapChange(*modelA, *modelB, execution, measures);
    addDeviation("a-to-b", *modelA, *modelB, execution, measures);
    addDeviation("b-to-a", *modelB, *modelA, execution, measures);
  }
  return comparison;
}

} // namespace scan
