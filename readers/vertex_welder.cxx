// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/vertex_welder.h"

#include "filters/base/error.h"

#include <bit>

namespace scan
{
namespace
{

using Bits = std::array<std::uint64_t, 3>;

/// Not a number equals itself bit by bit only.
Bits bitsOf(const Vec3& point)
{
  return std::bit_cast<Bits>(point);
}

std::uint64_t hashOf(const Vec3& point)
{
  // the coordinates do not wait for each other
  const auto [x, y, z] = bitsOf(point);
  std::uint64_t value = (x ^ (x >> 32U)) * 0x9e3779b97f4a7c15ULL;
  value ^= std::rotl((y ^ (y >> 32U)) * 0xbf58476d1ce4e5b9ULL, 21);
  value ^= std::rotl((z ^ (z >> 32U)) * 0x94d049bb133111ebULL, 42);
  value = (value ^ (value >> 32U)) * 0xd6e8feb86659fd93ULL;
  return value ^ (value >> 32U);
}

std::uint32_t tagOf(std::uint64_t hash)
{
  return static_cast<std::uint32_t>(hash >> 32U);
}

} // namespace

VertexWelder::VertexWelder(std::vector<Vec3>& points, std::size_t expected)
  : Points(points)
  , Slots(std::bit_ceil(expected * 2 + 16))
{
  this->Points.reserve(expected);
}

void VertexWelder::prefetch(std::span<const Vec3> batch)
{
  const std::size_t mask = this->Slots.size() - 1;
  for (std::size_t i = 0; i < batch.size(); ++i)
  {
    const Vec3& p = batch[i];
    this->Keys[i] = { p.x + 0.0, p.y + 0.0, p.z + 0.0 }; // -0 becomes 0
    this->Hashes[i] = hashOf(this->Keys[i]);
    __builtin_prefetch(&this->Slots[this->Hashes[i] & mask]);
  }
  for (std::size_t i = 0; i < batch.size(); ++i)
  {
    const Slot& slot = this->Slots[this->Hashes[i] & mask];
    if (slot.tag == tagOf(this->Hashes[i]) && slot.point != kNone)
    {
      __builtin_prefetch(&this->Points[slot.point]);
    }
  }
}

Index VertexWelder::add(const Vec3& key, std::uint64_t hash)
{
  std::size_t slot = this->slotOf(key, hash);
  if (this->Slots[slot].point != kNone)
  {
    return this->Slots[slot].point;
  }
  if (this->Points.size() + 1 >= kNone)
  {
    throw Error(ErrorCode::limit, "more than 4294967294 distinct points; split the model");
  }
  if (this->Points.size() * 2 >= this->Slots.size())
  {
    this->grow();
    slot = this->slotOf(key, hash);
  }
  const auto index = static_cast<Index>(this->Points.size());
  this->Slots[slot] = { index, tagOf(hash) };
  this->Points.push_back(key);
  return index;
}

std::size_t VertexWelder::slotOf(const Vec3& key, std::uint64_t hash) const
{
  const std::size_t mask = this->Slots.size() - 1;
  std::size_t at = hash & mask;
  for (;; at = (at + 1) & mask)
  {
    const Slot& slot = this->Slots[at];
    if (slot.point == kNone ||
      (slot.tag == tagOf(hash) && bitsOf(this->Points[slot.point]) == bitsOf(key)))
    {
      return at;
    }
  }
}

void VertexWelder::grow()
{
  this->Slots.assign(this->Slots.size() * 2, Slot());
  for (std::size_t i = 0; i < this->Points.size(); ++i)
  {
    const std::uint64_t hash = hashOf(this->Points[i]);
    this->Slots[this->slotOf(this->Points[i], hash)] = { static_cast<Index>(i), tagOf(hash) };
  }
}

} // namespace scan
