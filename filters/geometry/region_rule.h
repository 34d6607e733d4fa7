// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/length.h"
#include "filters/geometry/region_view.h"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace scan
{

/// What belongs to a region, for any model: an expression. As text, from what binds most:
///
///   (a)  !a  a & b  then a + b and a - b from left to right, with functions for a and b:
///   all, none, box(x,y,z, x,y,z), sphere(x,y,z, r), plane(x,y,z, nx,ny,nz),
///   brush(r, x,y,z, ...), rectangle(VIEW, x,y, x,y), polygon(VIEW, x,y, x,y, x,y, ...),
///   depth(VIEW, x,y,z), component(x,y,z), component(a), grow(a, n), shrink(a, n),
///   curvature(min, max), deviation(min, max), array(NAME, min, max), points(i, ...),
///   triangles(i, ...)
///
/// VIEW is a side of kViewSides, from(eye, target, up) or along(direction, up). Coordinates are in
/// model units, r is any Length. What they mean: chooseElements() and docs/manual.md.
struct RegionRule
{
  enum class Kind
  {
    all,
    none,
    box,
    sphere,
    plane,
    brush,
    rectangle,
    polygon,
    depth,
    componentAt,
    componentOf,
    curvature,
    array,
    grow,
    shrink,
    points,
    triangles,
    opposite, ///< !a
    both,     ///< a & b & ...
    either,   ///< a + b + ...
    without   ///< a - b - ...
  };

  Kind kind = Kind::none;
  RegionView view;
  Length radius;
  std::vector<double> numbers; ///< all but those of the view, in the order of the text
  std::string array;
  std::vector<RegionRule> parts;

  friend bool operator==(const RegionRule&, const RegionRule&) = default;
};

/// Rules that others may name.
using RegionNames = std::map<std::string, RegionRule, std::less<>>;

/// The rule that a text stands for; a name in it stands for its whole rule, so that the result
/// needs no names.
/// @throws Error{badParameter} that tells the character where the text goes wrong and what is
///   expected there; also for more than 10,000 functions and operators, or 100 within each other
RegionRule parseRegionRule(std::string_view text, const RegionNames& names = {});

/// Checks a text for names that are not known yet.
/// @throws Error as parseRegionRule(), but not for an unknown name
void checkRegionRule(std::string_view text);

/// The text that parseRegionRule() turns into the same rule; equal rules have equal texts.
std::string textOf(const RegionRule& rule);

/// Whether a region may have this name: letters, digits, - and _, a letter first, and no function.
bool isRegionName(std::string_view name);

} // namespace scan
