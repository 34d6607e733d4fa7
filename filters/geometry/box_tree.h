// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/delaunay_predicates.h"
#include "filters/geometry/large_array.h"
#include "filters/geometry/mesh.h"
#include "filters/geometry/triangle_tree.h"

#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

namespace scan
{

/// Eight boxes, side by side for vector registers. Places without a box are nowhere.
struct EightBoxes
{
  using Row = std::array<Pair, 4>;
  std::array<Row, 3> low;
  std::array<Row, 3> high;

  /// One bit for each box that touches another.
  unsigned touching(const Box& box) const;

  /// Squared distances of the boxes from a point; 0 inside, infinity where there is no box.
  Row squaredDistances(const Vec3& at) const;
};

/// The boxes of triangles in levels of groups of eight, along a Hilbert curve: no pointers, the
/// children of group g are groups 8 g to 8 g + 7 of the level below, those of the lowest level
/// places in the order of the triangles. For what is built on it see triangle_tree.h.
class BoxTree
{
public:
  static constexpr std::size_t kFan = 8;

  /// @param triangles those to take, different ones
  /// Throws Error badInput for points of theirs that are missing or not finite.
  BoxTree(const TriMesh& mesh, std::span<const Index> triangles, Execution& execution);

  /// Number of triangles.
  std::size_t size() const { return this->Order.size(); }
  /// The triangle in a place.
  Index operator[](std::size_t place) const { return this->Order[place]; }

  /// From the lowest to the one with a single group; none without triangles.
  std::size_t levels() const { return this->Levels.size(); }
  std::span<const EightBoxes> level(std::size_t number) const { return this->Levels[number]; }

  /// Calls visit(group, touching) for the lowest groups from `first` on that have boxes which touch
  /// another, in their order; `touching` has a bit for each such box.
  template <class Visit>
  void forGroupsTouching(const Box& box, std::size_t first, Visit&& visit) const;

private:
  std::vector<Index> Order;
  std::vector<LargeArray<EightBoxes>> Levels;
};

/// The box around a triangle.
Box boxOf(const TriMesh& mesh, Index triangle);

inline unsigned EightBoxes::touching(const Box& box) const
{
  using Mask __attribute__((vector_size(16))) = std::int64_t;
  Mask hits{};
  for (std::int64_t i = 0; i < 4; ++i)
  {
    const auto k = static_cast<std::size_t>(i);
    const Mask hit = (this->low[0][k] <= box.high.x) & (this->high[0][k] >= box.low.x) &
      (this->low[1][k] <= box.high.y) & (this->high[1][k] >= box.low.y) &
      (this->low[2][k] <= box.high.z) & (this->high[2][k] >= box.low.z);
    hits |= hit & Mask{ 1LL << (2 * i), 2LL << (2 * i) };
  }
  return static_cast<unsigned>(hits[0] | hits[1]);
}

inline EightBoxes::Row EightBoxes::squaredDistances(const Vec3& at) const
{
  Row squares;
  for (std::size_t k = 0; k < 4; ++k)
  {
    const auto beyond = [k](const Row& lows, const Row& highs, double where)
    { return larger(larger(lows[k] - where, where - highs[k]), Pair{}); };
    const Pair x = beyond(this->low[0], this->high[0], at.x);
    const Pair y = beyond(this->low[1], this->high[1], at.y);
    const Pair z = beyond(this->low[2], this->high[2], at.z);
    squares[k] = x * x + y * y + z * z;
  }
  return squares;
}

template <class Visit>
void BoxTree::forGroupsTouching(const Box& box, std::size_t first, Visit&& visit) const
{
  struct Step
  {
    std::size_t level;
    std::size_t group;
  };
  if (this->Levels.empty())
  {
    return;
  }
  std::array<Step, 8 * kFan * 2> stack; // 32 bits make no more than eleven levels
  std::size_t waiting = 0;
  stack[waiting++] = { this->Levels.size() - 1, 0 };
  while (waiting > 0)
  {
    const Step step = stack[--waiting];
    unsigned touching = this->Levels[step.level][step.group].touching(box);
    if (step.level == 0)
    {
      if (touching != 0)
      {
        visit(step.group, touching);
      }
      continue;
    }
    for (; touching != 0; touching &= ~(1U << (std::bit_width(touching) - 1)))
    {
      const std::size_t child = kFan * step.group + std::bit_width(touching) - 1;
      const std::size_t afterLast = (child + 1) << (3 * (step.level - 1));
      if (afterLast > first)
      {
        stack[waiting++] = { step.level - 1, child };
      }
    }
  }
}

} // namespace scan
