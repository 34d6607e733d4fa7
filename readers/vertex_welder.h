// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/mesh.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace scan
{

/// Gives equal points one index, in the order of their first appearance. Points are equal when
/// their coordinates are, bit by bit; -0 counts as 0. Deterministic, constant time per point.
class VertexWelder
{
public:
  /// How many points add() takes best: their memory is fetched while others are looked at.
  static constexpr std::size_t kBatch = 192;

  /// @param points where new points go; starts empty and is changed by nobody else
  /// @param expected number of distinct points; a guess, only time and storage depend on it
  VertexWelder(std::vector<Vec3>& points, std::size_t expected);

  /// Calls take(index) for each of at most kBatch points, in their order. Throws Error limit for
  /// the 2^32 - 1st distinct point.
  template <class Take>
  void add(std::span<const Vec3> batch, const Take& take)
  {
    this->prefetch(batch);
    for (std::size_t i = 0; i < batch.size(); ++i)
    {
      take(this->add(this->Keys[i], this->Hashes[i]));
    }
  }

private:
  /// Open addressing: a point, and bits of its hash that tell most others from it.
  struct Slot
  {
    Index point = kNone; // free
    std::uint32_t tag = 0;
  };

  void prefetch(std::span<const Vec3> batch);
  Index add(const Vec3& key, std::uint64_t hash);
  std::size_t slotOf(const Vec3& key, std::uint64_t hash) const;
  void grow();

  std::vector<Vec3>& Points;
  std::vector<Slot> Slots; // a power of two
  std::array<Vec3, kBatch> Keys;
  std::array<std::uint64_t, kBatch> Hashes = {};
};

} // namespace scan
