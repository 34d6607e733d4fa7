// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/point_links.h"

#include "filters/geometry/half_edges.h"

#include <algorithm>
#include <array>
#include <atomic>

namespace scan
{
namespace
{

/// One end of the edge that a triangle has opposite a point: ends 2 e and 2 e + 1 are one edge's.
struct LinkEnd
{
  Index point;
  Index end;
};

/// What opposes a point in its triangles: a cycle around an inner point, a path along a boundary
/// point.
class Link
{
public:
  void begin() { this->Ends.clear(); }
  void add(const Triangle& triangle, Index point)
  {
    const std::size_t k = triangle[0] == point ? 0 : triangle[1] == point ? 1 : 2;
    for (const std::size_t other : { k + 1, k + 2 })
    {
      this->Ends.push_back({ triangle[other % 3], static_cast<Index>(this->Ends.size()) });
    }
  }

  /// Sorts the ends; neighbours() may be asked then.
  PointKind finish();

  /// Whether the triangles of a cycle face the same side; behind finish().
  bool isOriented() const { return this->IsOriented; }

  /// Fills in at most one more than there were add(); tells how many.
  Index neighbours(PointKind kind, Index* to) const;

private:
  std::size_t edgesFrom(std::size_t start) const;

  std::vector<LinkEnd> Ends;
  std::vector<Index> Place;  // per end, in Ends
  std::vector<Index> Single; // places of points that one edge ends at
  bool IsOriented = false;
};

PointKind Link::finish()
{
  if (this->Ends.size() < 2)
  {
    return PointKind::irregular;
  }
  std::sort(this->Ends.begin(), this->Ends.end(),
    [](const LinkEnd& a, const LinkEnd& b)
    { return a.point != b.point ? a.point < b.point : a.end < b.end; });
  this->IsOriented = true;
  this->Place.resize(this->Ends.size());
  this->Single.clear();
  for (std::size_t i = 0; i < this->Ends.size();)
  {
    std::size_t same = i;
    for (; same < this->Ends.size() && this->Ends[same].point == this->Ends[i].point; ++same)
    {
      this->Place[this->Ends[same].end] = static_cast<Index>(same);
    }
    const bool isPassed = same - i == 2 && ((this->Ends[i].end ^ this->Ends[i + 1].end) & 1U) == 1;
    this->IsOriented = this->IsOriented && isPassed;
    if (same - i > 2)
    {
      return PointKind::irregular;
    }
    if (same - i == 1)
    {
      this->Single.push_back(static_cast<Index>(i));
    }
    i = same;
  }
  const bool isPath = this->Single.size() == 2;
  const std::size_t edges = this->Ends.size() / 2;
  if ((!isPath && !this->Single.empty()) || (!isPath && edges < 3) ||
    this->edgesFrom(isPath ? this->Single[0] : 0) != edges)
  {
    return PointKind::irregular;
  }
  return isPath ? PointKind::boundary : PointKind::inner;
}

/// How many edges hang together with that place, which begins them if they are a path.
std::size_t Link::edgesFrom(std::size_t start) const
{
  std::size_t place = start;
  for (std::size_t edges = 1;; ++edges)
  {
    const std::size_t far = this->Place[this->Ends[place].end ^ 1U];
    const Index point = this->Ends[far].point;
    if (far > 0 && this->Ends[far - 1].point == point)
    {
      place = far - 1;
    }
    else if (far + 1 < this->Ends.size() && this->Ends[far + 1].point == point)
    {
      place = far + 1;
    }
    else
    {
      return edges;
    }
    if (place == start)
    {
      return edges;
    }
  }
}

Index Link::neighbours(PointKind kind, Index* to) const
{
  Index count = 0;
  if (kind == PointKind::boundary)
  {
    for (const Index place : this->Single)
    {
      to[count++] = this->Ends[place].point;
    }
  }
  else if (kind == PointKind::inner)
  {
    for (std::size_t i = 0; i < this->Ends.size(); i += 2)
    {
      to[count++] = this->Ends[i].point;
    }
  }
  return count;
}

/// The points around one whose triangles all face one side and go round it, rising, into `to`; how
/// many, or 0 when they do not, or are too many for this short way.
Index ringAround(const TriMesh& mesh, std::span<const Index> triangles, Index point, Index* to)
{
  constexpr std::size_t kMost = 12;
  if (triangles.size() < 3 || triangles.size() > kMost)
  {
    return 0;
  }
  std::array<Index, kMost> next{};
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    const Triangle& triangle = mesh.triangles[triangles[i]];
    const std::size_t k = triangle[0] == point ? 0 : triangle[1] == point ? 1 : 2;
    to[i] = triangle[(k + 1) % 3];
    next[i] = triangle[(k + 2) % 3];
  }
  Index* const end = to + triangles.size();
  Index at = next[0];
  std::size_t steps = 1;
  for (; at != to[0] && steps < triangles.size(); ++steps)
  {
    const Index* const found = std::find(to, end, at);
    if (found == end)
    {
      return 0;
    }
    at = next[static_cast<std::size_t>(found - to)];
  }
  if (at != to[0] || steps != triangles.size()) // back at once after all: each point was met once
  {
    return 0;
  }
  std::sort(to, end);
  return static_cast<Index>(triangles.size());
}

/// Per point its triangles.
PointLists trianglesOfPoints(const TriMesh& mesh)
{
  PointLists lists;
  lists.begins.resize(mesh.points.size() + 1);
  std::fill(lists.begins.begin(), lists.begins.end(), 0);
  for (const Triangle& triangle : mesh.triangles)
  {
    for (const Index point : triangle)
    {
      ++lists.begins[point];
    }
  }
  Index end = 0;
  for (Index& begin : lists.begins)
  {
    end += begin;
    begin = end;
  }
  lists.items.resize(end);
  for (std::size_t t = mesh.triangles.size(); t-- > 0;)
  {
    for (const Index point : mesh.triangles[t])
    {
      lists.items[--lists.begins[point]] = static_cast<Index>(t);
    }
  }
  return lists;
}

} // namespace

PointLinks linkPoints(const TriMesh& mesh, Execution& execution)
{
  requireCorners(mesh);
  const std::size_t points = mesh.points.size();
  PointLinks links;
  links.kinds.resize(points);
  links.triangles = trianglesOfPoints(mesh);
  const PointLists& triangles = links.triangles;
  std::vector<Index> counts(points);
  LargeArray<Index> roomy(triangles.items.size() + points); // one more neighbour than triangles
  constexpr std::size_t kGrain = 8192;
  std::atomic<bool> isClosed = !mesh.triangles.empty();
  execution.parallelFor(points, kGrain,
    [&](std::size_t begin, std::size_t end)
    {
      Link link;
      for (std::size_t i = begin; i < end; ++i)
      {
        Index* const near = roomy.data() + triangles.begins[i] + i;
        counts[i] = ringAround(mesh, triangles.of(i), static_cast<Index>(i), near);
        if (counts[i] > 0)
        {
          links.kinds[i] = PointKind::inner;
          continue;
        }
        link.begin();
        for (const Index t : triangles.of(i))
        {
          link.add(mesh.triangles[t], static_cast<Index>(i));
        }
        links.kinds[i] = link.finish();
        const bool isUsed = !triangles.of(i).empty();
        if (isUsed && (links.kinds[i] != PointKind::inner || !link.isOriented()))
        {
          isClosed.store(false, std::memory_order_relaxed);
        }
        counts[i] = link.neighbours(links.kinds[i], near);
      }
    });
  links.isClosed = isClosed;
  links.neighbours = makeLists(
    points, execution, [&](std::size_t i) { return counts[i]; },
    [&](std::size_t i, std::span<Index> list)
    { std::copy_n(roomy.data() + triangles.begins[i] + i, list.size(), list.data()); });
  return links;
}

} // namespace scan
