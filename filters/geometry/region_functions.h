// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/region_rule.h"

#include <array>
#include <cstddef>
#include <string_view>

namespace scan
{

/// The array that deviation() means.
inline constexpr std::string_view kDeviation = "Deviation";

/// A function of rules. Its arguments stand in the order of the fields.
struct RegionFunction
{
  std::string_view form; ///< as people see it; the name is what stands before the parenthesis
  RegionRule::Kind kind;
  bool view = false;
  bool rule = false;
  bool array = false;
  bool radiusFirst = false;
  std::size_t numbers = 0; ///< at least
  std::size_t more = 0;    ///< how many more may follow, again and again
  bool radiusLast = false;
  enum class Values
  {
    coordinates,
    range,
    counts
  } values = Values::coordinates;

  std::string_view name() const { return this->form.substr(0, this->form.find('(')); }
};

/// component is there twice, the one of numbers first; deviation() is a short form of array().
inline constexpr std::array<RegionFunction, 18> kRegionFunctions{ {
  { .form = "all", .kind = RegionRule::Kind::all },
  { .form = "none", .kind = RegionRule::Kind::none },
  { .form = "box(x,y,z, x,y,z)", .kind = RegionRule::Kind::box, .numbers = 6 },
  { .form = "sphere(x,y,z, r)",
    .kind = RegionRule::Kind::sphere,
    .numbers = 3,
    .radiusLast = true },
  { .form = "plane(x,y,z, nx,ny,nz)", .kind = RegionRule::Kind::plane, .numbers = 6 },
  { .form = "brush(r, x,y,z, ...)",
    .kind = RegionRule::Kind::brush,
    .radiusFirst = true,
    .numbers = 3,
    .more = 3 },
  { .form = "rectangle(VIEW, x,y, x,y)",
    .kind = RegionRule::Kind::rectangle,
    .view = true,
    .numbers = 4 },
  { .form = "polygon(VIEW, x,y, x,y, x,y, ...)",
    .kind = RegionRule::Kind::polygon,
    .view = true,
    .numbers = 6,
    .more = 2 },
  { .form = "depth(VIEW, x,y,z)", .kind = RegionRule::Kind::depth, .view = true, .numbers = 3 },
  { .form = "component(x,y,z)", .kind = RegionRule::Kind::componentAt, .numbers = 3 },
  { .form = "component(RULE)", .kind = RegionRule::Kind::componentOf, .rule = true },
  { .form = "curvature(min, max)",
    .kind = RegionRule::Kind::curvature,
    .numbers = 2,
    .values = RegionFunction::Values::range },
  { .form = "deviation(min, max)",
    .kind = RegionRule::Kind::array,
    .numbers = 2,
    .values = RegionFunction::Values::range },
  { .form = "array(NAME, min, max)",
    .kind = RegionRule::Kind::array,
    .array = true,
    .numbers = 2,
    .values = RegionFunction::Values::range },
  { .form = "grow(RULE, n)",
    .kind = RegionRule::Kind::grow,
    .rule = true,
    .numbers = 1,
    .values = RegionFunction::Values::counts },
  { .form = "shrink(RULE, n)",
    .kind = RegionRule::Kind::shrink,
    .rule = true,
    .numbers = 1,
    .values = RegionFunction::Values::counts },
  { .form = "points(i, ...)",
    .kind = RegionRule::Kind::points,
    .numbers = 1,
    .more = 1,
    .values = RegionFunction::Values::counts },
  { .form = "triangles(i, ...)",
    .kind = RegionRule::Kind::triangles,
    .numbers = 1,
    .more = 1,
    .values = RegionFunction::Values::counts },
} };

} // namespace scan
