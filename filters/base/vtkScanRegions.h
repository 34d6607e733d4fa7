// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/region_rule.h"

#include <vtkSmartPointer.h>

#include <cstdint>
#include <string>
#include <vector>

class vtkDataObject;
class vtkPolyData;

/// Regions of vtkPolyData. A region is given as text: the name of one that the data carries, or a
/// rule (filters/geometry/region_rule.h) that may use these names.
namespace scan::bridge
{

/// The regions that the data carries.
/// @throws Error{badParameter} where somebody else stored what is no rule
RegionNames regionsOf(vtkDataObject& data);

/// Makes the data carry a region, in place of one of the same name. The arrays are new ones: data
/// that share the old ones keep them.
void setRegion(vtkDataObject& data, const std::string& name, const RegionRule& rule);

/// Per point 1 in the region and 0 elsewhere. Arrays are those of the points.
/// @throws Error as parseRegionRule() and chooseElements()
std::vector<std::uint8_t> pointsInRegion(
  vtkPolyData& data, const std::string& region, Execution& execution);

/// The same per triangle of meshOf(). Arrays are those of the cells; of an array of the points a
/// triangle has the mean of its corners. Of vectors the length counts.
std::vector<std::uint8_t> trianglesInRegion(
  vtkPolyData& data, const std::string& region, Execution& execution);

/// Makes `output` the part of `input` that is in the region, or that is not: of a surface
/// keepTriangles(), of points keepPoints(). It carries the regions, the unit and the files on.
/// @throws Error as the functions above
void keepRegion(vtkPolyData& input, const std::string& region, bool isInside, vtkPolyData& output,
  Execution& execution);

/// The part of `input` in the region, or `input` itself where the region is empty text.
vtkSmartPointer<vtkPolyData> partOf(
  vtkPolyData& input, const std::string& region, Execution& execution);

} // namespace scan::bridge
