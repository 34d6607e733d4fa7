// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/vertex_welder.h"

#include "filters/base/error.h"

#include <array>
#include <bit>
#include <cstdint>

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

std::uint64_t hash(const Vec3& point)
{
  std::uint64_t value = std::bit_cast<std::uint64_t>(point.x);
  value = (value ^ (value >> 32U)) * 0x9e3779b97f4a7c15ULL;
  value = std::rotl(value, 29) ^ std::bit_cast<std::uint64_t>(point.y);
  value = (value ^ (value >> 32U)) * 0xbf58476d1ce4e5b9ULL;
  value = std::rotl(value, 29) ^ std::bit_cast<std::uint64_t>(point.z);
  value = (value ^ (value >> 32U)) * 0x94d049bb133111ebULL;
  return value ^ (value >> 31U);
}

} // namespace

VertexWelder::VertexWelder(std::vector<Vec3>& points, std::size_t expected)
  : Points(points)
  , Slots(std::bit_ceil(expected * 2 + 16), kNone)
{
  this->Points.reserve(expected);
}

Index VertexWelder::add(const Vec3& point)
{
  const Vec3 key = { point.x + 0.0, point.y + 0.0, point.z + 0.0 }; // -0 becomes 0
  std::size_t slot = this->slotOf(key);
  if (this->Slots[slot] != kNone)
  {
    return this->Slots[slot];
  }
  if (this->Points.size() + 1 >= kNone)
  {
    throw Error(ErrorCode::limit, "more than 4294967294 distinct points; split the model");
  }
  if (this->Points.size() * 2 >= this->Slots.size())
  {
    this->grow();
    slot = this->slotOf(key);
  }
  this->Slots[slot] = static_cast<Index>(this->Points.size());
  this->Points.push_back(key);
  return this->Slots[slot];
}

std::size_t VertexWelder::slotOf(const Vec3& point) const
{
  const std::size_t mask = this->Slots.size() - 1;
  std::size_t slot = static_cast<std::size_t>(hash(point)) & mask;
  while (this->Slots[slot] != kNone && bitsOf(this->Points[this->Slots[slot]]) != bitsOf(point))
  {
    slot = (slot + 1) & mask;
  }
  return slot;
}

void VertexWelder::grow()
{
  this->Slots.assign(this->Slots.size() * 2, kNone);
  for (std::size_t i = 0; i < this->Points.size(); ++i)
  {
    this->Slots[this->slotOf(this->Points[i])] = static_cast<Index>(i);
  }
}

} // namespace scan
