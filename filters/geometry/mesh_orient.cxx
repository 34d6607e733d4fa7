// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/mesh_orient.h"

#include "filters/geometry/incidence.h"

#include <algorithm>
#include <cstdint>

namespace scan
{
namespace
{

/// Side k of a triangle runs from its vertex k to the next; sides are numbered 3 * triangle + k.
Segment side(const std::vector<Triangle>& triangles, std::size_t number)
{
  const Triangle& triangle = triangles[number / 3];
  return { triangle[number % 3], triangle[(number + 1) % 3] };
}

/// Per side the other one at an edge of exactly two, else kNone.
std::vector<Index> sideMates(const std::vector<Triangle>& triangles, std::size_t pointCount)
{
  const auto ends = [&](std::size_t number)
  { return std::ranges::minmax(side(triangles, number)); };
  const Incidence sidesOf(pointCount, 3 * triangles.size(),
    [&](std::size_t number, auto&& visit) { visit(ends(number).min); });
  std::vector<Index> mates(3 * triangles.size(), kNone);
  std::vector<Index> sides;
  for (Index point = 0; point < pointCount; ++point)
  {
    const auto upper = [&](Index number) { return ends(number).max; };
    sides.assign(sidesOf.of(point).begin(), sidesOf.of(point).end());
    std::ranges::sort(sides, {}, upper);
    for (auto first = sides.begin(); first != sides.end();)
    {
      const auto last = std::ranges::upper_bound(first, sides.end(), upper(*first), {}, upper);
      if (last - first == 2)
      {
        mates[first[0]] = first[1];
        mates[first[1]] = first[0];
      }
      first = last;
    }
  }
  return mates;
}

} // namespace

void orientConsistently(std::vector<Triangle>& triangles, std::size_t pointCount)
{
  const std::vector<Index> mates = sideMates(triangles, pointCount);
  std::vector<std::uint8_t> visited(triangles.size(), 0);
  std::vector<std::uint8_t> turned(triangles.size(), 0);
  std::vector<Index> front;
  for (Index first = 0; first < triangles.size(); ++first)
  {
    if (visited[first])
    {
      continue;
    }
    visited[first] = 1;
    front.assign(1, first);
    for (std::size_t next = 0; next < front.size(); ++next) // breadth first: short seams
    {
      const Index triangle = front[next];
      for (Index number = 3 * triangle; number < 3 * triangle + 3; ++number)
      {
        const Index mate = mates[number];
        if (mate == kNone || visited[mate / 3])
        {
          continue;
        }
        // neighbours agree when they run along their edge in opposite directions
        const bool alike = side(triangles, number)[0] == side(triangles, mate)[0];
        visited[mate / 3] = 1;
        turned[mate / 3] = static_cast<std::uint8_t>(turned[triangle] ^ (alike ? 1U : 0U));
        front.push_back(mate / 3);
      }
    }
  }
  for (Index triangle = 0; triangle < triangles.size(); ++triangle)
  {
    if (turned[triangle])
    {
      std::swap(triangles[triangle][1], triangles[triangle][2]);
    }
  }
}

} // namespace scan
