// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/large_array.h"
#include "filters/geometry/mesh.h"

#include <cstdint>
#include <span>
#include <vector>

namespace scan
{

/// For each point the numbers of others, one list after the other.
struct PointLists
{
  LargeArray<Index> begins; ///< per point in `items`, and the end
  LargeArray<Index> items;

  std::span<const Index> of(std::size_t point) const
  {
    return { this->items.data() + this->begins[point],
      this->items.data() + this->begins[point + 1] };
  }
};

/// What the triangles at a point make of it.
enum class PointKind : std::uint8_t
{
  inner,    ///< they go round it
  boundary, ///< they are a fan with two free edges
  irregular ///< anything else: none, several fans, a collapsed triangle, a crowded edge
};

struct PointLinks
{
  std::vector<PointKind> kinds;
  /// Inner points: the points around, rising. Boundary points: the two beside it on the boundary.
  /// Irregular points: none.
  PointLists neighbours;
  /// Per point its triangles, rising.
  PointLists triangles;
  /// There are triangles, and all their points are inner ones and of triangles that face one side.
  bool isClosed = false;
};

/// Finds out what surrounds the points, whatever the orientation of the triangles. Linear time:
/// about 0.1 s for a million triangles where neighbours have numbers near each other.
/// Throws as requireCorners().
PointLinks linkPoints(const TriMesh& mesh, Execution& execution);

/// Lists with the lengths that count(point) tells, each filled by fill(point, list).
template <class Count, class Fill>
PointLists makeLists(std::size_t points, Execution& execution, Count&& count, Fill&& fill)
{
  PointLists lists;
  lists.begins.resize(points + 1);
  Index end = 0;
  for (std::size_t i = 0; i < points; ++i)
  {
    lists.begins[i] = end;
    end += count(i);
  }
  lists.begins[points] = end;
  lists.items.resize(end);
  constexpr std::size_t kGrain = 8192;
  execution.parallelFor(points, kGrain,
    [&](std::size_t begin, std::size_t stop)
    {
      for (std::size_t i = begin; i < stop; ++i)
      {
        fill(i,
          std::span(lists.items).subspan(lists.begins[i], lists.begins[i + 1] - lists.begins[i]));
      }
    });
  return lists;
}

/// The sum of valueOf(neighbour); fast for six, as most points have.
template <class ValueOf>
auto sumOf(std::span<const Index> neighbours, ValueOf&& valueOf)
{
  if (neighbours.size() == 6)
  {
    return ((valueOf(neighbours[0]) + valueOf(neighbours[1])) +
             (valueOf(neighbours[2]) + valueOf(neighbours[3]))) +
      (valueOf(neighbours[4]) + valueOf(neighbours[5]));
  }
  decltype(valueOf(Index{})) sum{};
  for (const Index other : neighbours)
  {
    sum = sum + valueOf(other);
  }
  return sum;
}

} // namespace scan
