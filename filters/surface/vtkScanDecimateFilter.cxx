// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/surface/vtkScanDecimateFilter.h"

#include <vtkObjectFactory.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

vtkStandardNewMacro(vtkScanDecimateFilter);

std::vector<scan::Phase> vtkScanDecimateFilter::Phases() const
{
  return { { "decimate", this->Engine == Method::quadric ? 1.0 : 20.0 } };
}

/// The number of triangles to leave of those in the region; 0 without one.
std::size_t vtkScanDecimateFilter::TargetOf(std::size_t inRegion) const
{
  if (this->Triangles > 0)
  {
    return static_cast<std::size_t>(this->Triangles);
  }
  const bool isHalf = this->Ratio == 0.0 && this->GetMaxDeviation().value() == 0.0;
  const double ratio = isHalf ? 0.5 : this->Ratio;
  return static_cast<std::size_t>(std::llround(ratio * static_cast<double>(inRegion)));
}

scan::SurfaceEdit vtkScanDecimateFilter::Edit(const Surface& surface, scan::Execution& execution)
{
  const std::vector<std::uint8_t> isInRegion = this->TrianglesInRegion(surface, execution);
  const auto inRegion = static_cast<std::size_t>(std::ranges::count(isInRegion, 1));
  scan::DecimateOptions options = this->Options;
  options.maxDeviation = surface.maxDeviation;
  options.isInRegion = isInRegion;
  if (const std::size_t target = this->TargetOf(inRegion);
      target > 0 || !std::isfinite(options.maxDeviation))
  {
    options.triangles = isInRegion.size() - inRegion + std::max<std::size_t>(target, 1);
  }
  if (this->Engine == Method::quadric)
  {
    this->Result = scan::decimate(surface.mesh, options, execution);
  }
  else
  {
    scan::OpenMeshConditions conditions = this->Conditions;
    if (this->LongestEdge.value() > 0.0)
    {
      conditions.longestEdge = InModelUnits(this->LongestEdge, surface);
    }
    this->Result = scan::decimateByOpenMesh(surface.mesh, options, conditions, execution);
  }
  if (const std::size_t left = this->Result.edit.mesh.triangles.size();
      options.triangles > 0 && left > options.triangles + 1)
  {
    this->AddNote(std::to_string(left) + " triangles are left instead of " +
      std::to_string(options.triangles) + ": fewer would break a condition");
  }
  if (this->Result.intersections > 0)
  {
    this->AddNote(std::to_string(this->Result.intersections) +
      " pairs of triangles intersect that did not before");
  }
  return std::exchange(this->Result.edit, {});
}
