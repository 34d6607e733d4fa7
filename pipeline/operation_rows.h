// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/error.h"
#include "filters/geometry/region_rule.h"
#include "filters/geometry/view_sides.h"
#include "pipeline/operation_table.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace scan
{

// The rows of the operation table, by stage, and what they are written with.

std::vector<Operation> regionOperations();
std::vector<Operation> pointOperations();
std::vector<Operation> wrapOperations();
std::vector<Operation> surfaceOperations();
std::vector<Operation> analysisOperations();

/// Of the operations that work on a part of the model; see vtkScanPolyDataFilter::SetRegion().
inline Parameter regionParameter()
{
  return { .name = "region",
    .defaultValue = "",
    .help = "only there: the name of a region, or a rule such as sphere(0,0,0,5); see select",
    .check = checkRegionRule };
}

/// The value of a parameter that completeValues() has made sure is there.
template <class T>
const T& valueOf(const ParameterValues& values, std::string_view name)
{
  return std::get<T>(values.find(name)->second);
}

/// The place of a text's value among its choices.
inline std::ptrdiff_t choiceOf(
  const ParameterValues& values, std::string_view name, const std::vector<std::string>& choices)
{
  return std::ranges::find(choices, valueOf<std::string>(values, name)) - choices.begin();
}

/// The point of an option that takes one at most.
inline std::optional<Vec3> singlePoint(const ParameterValues& values, const std::string& name)
{
  const auto& points = valueOf<PointList>(values, name);
  if (points.size() > 1)
  {
    throw Error(ErrorCode::badParameter, "--" + name + ": one point is enough");
  }
  return points.empty() ? std::nullopt : std::optional(points.front());
}

/// The names of kViewSides, behind those that come first.
inline std::vector<std::string> viewNames(std::vector<std::string> names = {})
{
  std::ranges::transform(kViewSides, std::back_inserter(names),
    [](const ViewSide& side) { return std::string(side.name); });
  return names;
}

/// The filter that the row's make() made.
template <class Filter>
const Filter& as(vtkAlgorithm& algorithm)
{
  return dynamic_cast<const Filter&>(algorithm);
}

inline ResultValue count(std::int64_t number)
{
  return number;
}

/// The same for sizes.
inline ResultValue sizeOf(std::size_t number)
{
  return count(static_cast<std::int64_t>(number));
}

} // namespace scan
