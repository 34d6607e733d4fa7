// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/self_intersections.h"

#include "filters/geometry/box_tree.h"
#include "filters/geometry/collect.h"
#include "filters/geometry/flat_triangles.h"
#include "filters/geometry/half_edges.h"
#include "filters/geometry/parallel_sort.h"
#include "filters/geometry/triangle_pair.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <functional>
#include <span>

namespace scan
{
namespace
{

using Pairs = std::vector<TrianglePair>;

bool hasArea(const TriMesh& mesh, Index triangle)
{
  const Triangle& t = mesh.triangles[triangle];
  return !isCollapsed(t) && !isFlat(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]);
}

/// The triangles with area, all or those with a mark.
template <class IsMarked>
std::vector<Index> withArea(const TriMesh& mesh, Execution& execution, IsMarked&& isMarked)
{
  return collect<Index>(static_cast<Index>(mesh.triangles.size()), execution,
    [&](Index triangle, std::vector<Index>& found)
    {
      if (isMarked(triangle) && hasArea(mesh, triangle))
      {
        found.push_back(triangle);
      }
    });
}

/// Runs find(group, pairs) for the groups of eight and sorts what it finds.
template <class Find>
Pairs pairsOf(std::size_t groups, Execution& execution, Find&& find)
{
  constexpr std::size_t kGroups = 256; // a step
  std::vector<Pairs> found((groups + kGroups - 1) / kGroups);
  execution.parallelFor(found.size(), 1,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t group = kGroups * begin; group < std::min(groups, kGroups * end); ++group)
      {
        find(group, found[group / kGroups]);
      }
    });
  Pairs pairs;
  for (const Pairs& some : found)
  {
    pairs.insert(pairs.end(), some.begin(), some.end());
  }
  sortInParallel(pairs, execution, std::less<>());
  return pairs;
}

/// Calls look(triangle) for the triangles that a group's bits stand for.
template <class Look>
void forBits(const BoxTree& tree, std::size_t group, unsigned bits, Look&& look)
{
  for (; bits != 0; bits &= bits - 1)
  {
    look(tree[BoxTree::kFan * group + static_cast<std::size_t>(std::countr_zero(bits))]);
  }
}

/// Tests a triangle with others.
void test(const TriMesh& mesh, Index triangle, Index other, Pairs& pairs)
{
  if (meetBeyondShared(mesh, mesh.triangles[triangle], mesh.triangles[other]))
  {
    pairs.push_back({ std::min(triangle, other), std::max(triangle, other) });
  }
}

/// Meets of the triangles of a group with those of the same group and of later ones.
void findInGroup(const TriMesh& mesh, const BoxTree& tree, std::size_t group, Pairs& pairs)
{
  const std::size_t first = BoxTree::kFan * group;
  const std::size_t count = std::min(BoxTree::kFan, tree.size() - first);
  std::array<Box, BoxTree::kFan> boxes;
  Box around = boxOf(mesh, tree[first]);
  for (std::size_t k = 0; k < count; ++k)
  {
    boxes[k] = boxOf(mesh, tree[first + k]);
    around.low = { std::min(around.low.x, boxes[k].low.x), std::min(around.low.y, boxes[k].low.y),
      std::min(around.low.z, boxes[k].low.z) };
    around.high = { std::max(around.high.x, boxes[k].high.x),
      std::max(around.high.y, boxes[k].high.y), std::max(around.high.z, boxes[k].high.z) };
  }
  tree.forGroupsTouching(around, group,
    [&](std::size_t other, unsigned touching)
    {
      for (std::size_t k = 0; k < count; ++k)
      {
        unsigned bits = touching & tree.level(0)[other].touching(boxes[k]);
        if (other == group)
        {
          bits &= ~0U << (k + 1); // the others of the group have been there
        }
        forBits(
          tree, other, bits, [&](Index triangle) { test(mesh, tree[first + k], triangle, pairs); });
      }
    });
}

} // namespace

Pairs selfIntersections(const TriMesh& mesh, Execution& execution)
{
  requireCorners(mesh);
  const auto isMarked = [](Index) { return true; };
  const BoxTree tree(mesh, withArea(mesh, execution, isMarked), execution);
  const std::size_t groups = (tree.size() + BoxTree::kFan - 1) / BoxTree::kFan;
  return pairsOf(groups, execution,
    [&](std::size_t group, Pairs& pairs) { findInGroup(mesh, tree, group, pairs); });
}

Pairs selfIntersections(
  const TriMesh& mesh, std::span<const Index> ofTriangles, Execution& execution)
{
  requireCorners(mesh);
  std::vector<std::uint8_t> isGiven(mesh.triangles.size(), 0);
  for (const Index triangle : ofTriangles)
  {
    isGiven[triangle] = 1;
  }
  const auto isMarked = [&](Index triangle) { return isGiven[triangle] != 0; };
  const BoxTree tree(mesh, withArea(mesh, execution, isMarked), execution);
  const std::size_t groups = (mesh.triangles.size() + BoxTree::kFan - 1) / BoxTree::kFan;
  return pairsOf(groups, execution,
    [&](std::size_t group, Pairs& pairs)
    {
      const std::size_t end = std::min(mesh.triangles.size(), BoxTree::kFan * (group + 1));
      for (std::size_t i = BoxTree::kFan * group; i < end; ++i)
      {
        const auto triangle = static_cast<Index>(i);
        const auto testGiven = [&](Index other)
        {
          // what is given on both sides is met twice
          if (isGiven[triangle] == 0 || triangle < other)
          {
            test(mesh, triangle, other, pairs);
          }
        };
        tree.forGroupsTouching(boxOf(mesh, triangle), 0,
          [&](std::size_t other, unsigned bits)
          {
            if (hasArea(mesh, triangle))
            {
              forBits(tree, other, bits, testGiven);
            }
          });
      }
    });
}

} // namespace scan
