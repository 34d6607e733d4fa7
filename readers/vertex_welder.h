// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/mesh.h"

#include <cstddef>
#include <vector>

namespace scan
{

/// Gives equal points one index, in the order of their first appearance. Points are equal when
/// their coordinates are, bit by bit; -0 counts as 0. Deterministic, constant time per point.
class VertexWelder
{
public:
  /// @param points where new points go; starts empty and is changed by nobody else
  /// @param expected number of distinct points; a guess, only time and storage depend on it
  VertexWelder(std::vector<Vec3>& points, std::size_t expected);

  /// Throws Error limit for the 2^32 - 1st distinct point.
  Index add(const Vec3& point);

private:
  std::size_t slotOf(const Vec3& point) const;
  void grow();

  std::vector<Vec3>& Points;
  std::vector<Index> Slots; // open addressing, a power of two, kNone = free
};

} // namespace scan
