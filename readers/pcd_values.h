// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "readers/pcd_header.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

/// The numbers of a point in a PCD file, whatever the type of their field.
namespace scan
{

/// The colour in a float's bits; old files have its number in the float's value instead, where the
/// bits would be a colour with a transparency that nobody writes.
inline std::uint32_t colorBits(float value)
{
  const bool isNumber = value >= 1.0F && value < 16777216.0F && value == std::trunc(value);
  return isNumber ? static_cast<std::uint32_t>(value) : std::bit_cast<std::uint32_t>(value);
}

/// The colour in a number of text.
inline std::uint32_t colorBits(double value, char type)
{
  if (type == 'F')
  {
    const bool isFloat = std::abs(value) <= static_cast<double>(std::numeric_limits<float>::max());
    return isFloat ? colorBits(static_cast<float>(value)) : 0U;
  }
  return std::abs(value) <= 4294967295.0
    ? static_cast<std::uint32_t>(static_cast<std::int64_t>(value))
    : 0U;
}

template <class T>
double loadValue(const char* at)
{
  T value;
  std::memcpy(&value, at, sizeof(T));
  return static_cast<double>(value);
}

/// A little-endian number.
inline double loadReal(const char* at, const PcdField& field)
{
  if (field.type == 'F')
  {
    return field.size == 4 ? loadValue<float>(at) : loadValue<double>(at);
  }
  const bool isSigned = field.type == 'I';
  switch (field.size)
  {
    case 1:
      return isSigned ? loadValue<std::int8_t>(at) : loadValue<std::uint8_t>(at);
    case 2:
      return isSigned ? loadValue<std::int16_t>(at) : loadValue<std::uint16_t>(at);
    case 4:
      return isSigned ? loadValue<std::int32_t>(at) : loadValue<std::uint32_t>(at);
    default:
      return isSigned ? loadValue<std::int64_t>(at) : loadValue<std::uint64_t>(at);
  }
}

inline std::uint32_t loadColor(const char* at, const PcdField& field)
{
  std::uint32_t bits = 0;
  std::memcpy(&bits, at, sizeof(bits));
  return field.type == 'F' ? colorBits(std::bit_cast<float>(bits)) : bits;
}

} // namespace scan
