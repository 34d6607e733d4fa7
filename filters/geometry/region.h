// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/mesh.h"
#include "filters/geometry/region_adjacency.h"
#include "filters/geometry/region_rule.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace scan
{

/// The model that a rule is applied to. The mesh must outlive it.
struct RegionDomain
{
  const TriMesh& mesh;
  RegionElements elements = RegionElements::points;
  double millimetresPerUnit = 0.0; ///< of the coordinates; 0: unknown

  /// One value an element of the array of that name; throws Error when there is none. May be null:
  /// there are no arrays.
  std::function<std::vector<double>(const std::string& name)> valuesOf;
};

/// Which elements belong to a region: 1 for those that do, 0 for the others.
///
/// A triangle stands at its centroid, so a region and its opposite share the triangles out. Borders
/// belong to a box, rectangle, sphere, brush, to a range, to the half-spaces of plane and depth. A
/// polygon follows the even-odd rule; of two polygons with a common side exactly one has what lies
/// there. component(x,y,z) is the part with the element nearest to that place, component(a) all
/// parts that `a` has an element of; what is connected, and the rings of grow: RegionAdjacency.
/// shrink(a, n) is !grow(!a, n). curvature: meanCurvature(), of a triangle the mean of its corners.
///
/// The same on any number of threads. Time about linear in the elements, times the parts of the
/// rule and the segments of a brush; curvature takes about 5 microseconds a point.
/// @throws Error{badParameter} for points() on triangles and triangles() on points, numbers that
///   there are not, and whatever valuesOf throws; Error{badInput} for a triangle with a missing
///   point and a length without a meaning here
std::vector<std::uint8_t> chooseElements(
  const RegionRule& rule, const RegionDomain& domain, Execution& execution);

} // namespace scan
