// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/box_tree.h"

#include "filters/base/error.h"
#include "filters/geometry/hilbert_order.h"

#include <algorithm>
#include <atomic>
#include <limits>

namespace scan
{
namespace
{

constexpr std::size_t kGrain = 1 << 11; // groups

constexpr double kNowhere = std::numeric_limits<double>::infinity();

bool isGood(const TriMesh& mesh, const Triangle& triangle)
{
  double zero = 0.0; // or NaN
  for (const Index corner : triangle)
  {
    if (corner >= mesh.points.size())
    {
      return false;
    }
    const Vec3 nothing = mesh.points[corner] * 0.0;
    zero += nothing.x + nothing.y + nothing.z;
  }
  return zero == 0.0;
}

/// The middles of triangles' boxes, made so that they do not overflow.
std::vector<Vec3> middles(
  const TriMesh& mesh, std::span<const Index> triangles, Execution& execution)
{
  std::vector<Vec3> middle(triangles.size());
  std::atomic<bool> isBad = false;
  execution.parallelFor(triangles.size(), kGrain * BoxTree::kFan,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        if (!isGood(mesh, mesh.triangles[triangles[i]]))
        {
          isBad = true;
          return;
        }
        const Box box = boxOf(mesh, triangles[i]);
        middle[i] = box.low * 0.5 + box.high * 0.5;
      }
    });
  if (isBad)
  {
    throw Error(ErrorCode::badInput,
      "a triangle has a corner that is missing or not finite; mend the surface first");
  }
  return middle;
}

void clear(EightBoxes& boxes)
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    boxes.low[axis].fill(Pair{ kNowhere, kNowhere });
    boxes.high[axis].fill(Pair{ -kNowhere, -kNowhere });
  }
}

void set(EightBoxes& boxes, std::size_t place, const Box& box)
{
  const auto put = [place](EightBoxes::Row& row, double value)
  { row[place / 2][place % 2] = value; };
  put(boxes.low[0], box.low.x);
  put(boxes.low[1], box.low.y);
  put(boxes.low[2], box.low.z);
  put(boxes.high[0], box.high.x);
  put(boxes.high[1], box.high.y);
  put(boxes.high[2], box.high.z);
}

/// The box around all eight.
Box around(const EightBoxes& boxes)
{
  const auto least = [](const EightBoxes::Row& row)
  {
    const Pair pair = -larger(larger(-row[0], -row[1]), larger(-row[2], -row[3]));
    return std::min(pair[0], pair[1]);
  };
  const auto most = [](const EightBoxes::Row& row)
  {
    const Pair pair = larger(larger(row[0], row[1]), larger(row[2], row[3]));
    return std::max(pair[0], pair[1]);
  };
  return { { least(boxes.low[0]), least(boxes.low[1]), least(boxes.low[2]) },
    { most(boxes.high[0]), most(boxes.high[1]), most(boxes.high[2]) } };
}

/// Groups of eight of `count` boxes.
template <class BoxAt>
LargeArray<EightBoxes> grouped(std::size_t count, BoxAt&& boxAt, Execution& execution)
{
  LargeArray<EightBoxes> groups((count + BoxTree::kFan - 1) / BoxTree::kFan);
  execution.parallelFor(groups.size(), kGrain,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t group = begin; group < end; ++group)
      {
        const std::size_t first = BoxTree::kFan * group;
        const std::size_t boxes = std::min(BoxTree::kFan, count - first);
        if (boxes < BoxTree::kFan)
        {
          clear(groups[group]);
        }
        for (std::size_t place = 0; place < boxes; ++place)
        {
          set(groups[group], place, boxAt(first + place));
        }
      }
    });
  return groups;
}

} // namespace

Box boxOf(const TriMesh& mesh, Index triangle)
{
  const auto& [i, j, k] = mesh.triangles[triangle];
  const Vec3& a = mesh.points[i];
  const Vec3& b = mesh.points[j];
  const Vec3& c = mesh.points[k];
  return { { std::min(std::min(a.x, b.x), c.x), std::min(std::min(a.y, b.y), c.y),
             std::min(std::min(a.z, b.z), c.z) },
    { std::max(std::max(a.x, b.x), c.x), std::max(std::max(a.y, b.y), c.y),
      std::max(std::max(a.z, b.z), c.z) } };
}

BoxTree::BoxTree(const TriMesh& mesh, std::span<const Index> triangles, Execution& execution)
{
  this->Order = hilbertOrder(middles(mesh, triangles, execution), execution);
  for (Index& place : this->Order)
  {
    place = triangles[place];
  }
  if (this->Order.empty())
  {
    return;
  }
  const auto triangleBox = [&](std::size_t place) { return boxOf(mesh, this->Order[place]); };
  this->Levels.push_back(grouped(this->Order.size(), triangleBox, execution));
  while (this->Levels.back().size() > 1)
  {
    const LargeArray<EightBoxes>& below = this->Levels.back();
    const auto groupBox = [&](std::size_t group) { return around(below[group]); };
    LargeArray<EightBoxes> groups = grouped(below.size(), groupBox, execution);
    this->Levels.push_back(std::move(groups));
  }
}

} // namespace scan
