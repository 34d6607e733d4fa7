// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/mesh.h"
#include "readers/ply_header.h"
#include "readers/source.h"
#include "readers/text_scanner.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <type_traits>

/// The values behind a PLY header, one after the other, in each of the encodings. Both classes have
/// the same functions; each throws Error parse when the value is malformed or the file ends.
namespace scan
{

class PlyAsciiBody
{
public:
  static constexpr bool kHasRecords = false; // of a size that the header gives

  PlyAsciiBody(const Source& source, std::size_t offset)
    : Text(source)
    , At(source.begin() + offset)
  {
  }

  const char* position() const { return this->At; }

  double real(PlyType)
  {
    this->At = skipSpace(this->At, this->Text.end());
    if (this->At == this->Text.end())
    {
      this->fail("the file ends too early; it is truncated");
    }
    double value = 0.0;
    const char* const end = parseNumber(this->At, this->Text.end(), value);
    if (end == nullptr || (end != this->Text.end() && !isBlank(*end) && !isLineEnd(*end)))
    {
      this->fail("expected a number, found " + quoted(word(this->At, this->Text.end())));
    }
    this->At = end;
    return value;
  }

  std::int64_t integer(PlyType type)
  {
    const char* const before = skipSpace(this->At, this->Text.end());
    const double value = this->real(type);
    if (!(std::abs(value) <= 1e15) || value != std::trunc(value))
    {
      this->fail("expected an integer, found " + quoted(word(before, this->Text.end())));
    }
    return static_cast<std::int64_t>(value);
  }

  void skip(PlyType type, std::uint64_t count)
  {
    for (std::uint64_t i = 0; i < count; ++i)
    {
      this->real(type);
    }
  }

  /// Upper bound for the number of values of the type that are left: one takes two characters.
  std::uint64_t left(PlyType) const
  {
    return static_cast<std::uint64_t>(this->Text.end() - this->At + 1) / 2;
  }

  /// How many of left(uint8) an element takes at least.
  std::uint64_t leastSize(const PlyElement& element) const { return element.properties.size(); }

  [[noreturn]] void fail(const std::string& what) const { this->Text.failAtLine(this->At, what); }

private:
  const Source& Text;
  const char* At;
};

template <std::endian Order>
class PlyBinaryBody
{
public:
  static constexpr bool kHasRecords = true;
  static constexpr std::size_t kTriangleSize = 13; // bytes

  PlyBinaryBody(const Source& source, std::size_t offset)
    : Data(source)
    , At(source.begin() + offset)
  {
  }

  const char* position() const { return this->At; }

  double real(PlyType type)
  {
    switch (type)
    {
      case PlyType::float32:
        return this->take<float>();
      case PlyType::float64:
        return this->take<double>();
      default:
        return static_cast<double>(this->integer(type));
    }
  }

  std::int64_t integer(PlyType type)
  {
    switch (type)
    {
      case PlyType::int8:
        return this->take<std::int8_t>();
      case PlyType::uint8:
        return this->take<std::uint8_t>();
      case PlyType::int16:
        return this->take<std::int16_t>();
      case PlyType::uint16:
        return this->take<std::uint16_t>();
      case PlyType::int32:
        return this->take<std::int32_t>();
      case PlyType::uint32:
        return this->take<std::uint32_t>();
      default:
        break;
    }
    const double value = type == PlyType::float32 ? this->take<float>() : this->take<double>();
    if (!(std::abs(value) <= 1e15) || value != std::trunc(value))
    {
      this->fail("expected an integer");
    }
    return static_cast<std::int64_t>(value);
  }

  void skip(PlyType type, std::uint64_t count)
  {
    if (count > this->left(type))
    {
      this->failAtEnd();
    }
    this->At += count * plySize(type);
  }

  bool hasBytes(std::size_t count) const
  {
    return static_cast<std::size_t>(this->Data.end() - this->At) >= count;
  }

  /// Skips bytes that are there.
  void advance(std::size_t count) { this->At += count; }

  /// A value of the record at the position, which is in the file as a whole.
  double realAt(std::size_t offset, PlyType type) const
  {
    const char* const at = this->At + offset;
    switch (type)
    {
      case PlyType::int8:
        return load<std::int8_t>(at);
      case PlyType::uint8:
        return load<std::uint8_t>(at);
      case PlyType::int16:
        return load<std::int16_t>(at);
      case PlyType::uint16:
        return load<std::uint16_t>(at);
      case PlyType::int32:
        return load<std::int32_t>(at);
      case PlyType::uint32:
        return load<std::uint32_t>(at);
      case PlyType::float32:
        return static_cast<double>(load<float>(at));
      case PlyType::float64:
        break;
    }
    return load<double>(at);
  }

  /// The corners of the list at the position, when it is as of most triangles: three indices of 32
  /// bits behind a byte. The position stays.
  bool peekTriangle(const PlyProperty& list, Triangle& corners) const
  {
    const bool is32 = list.type == PlyType::int32 || list.type == PlyType::uint32;
    if (!is32 || list.countType != PlyType::uint8 || !this->hasBytes(kTriangleSize) ||
      *this->At != 3)
    {
      return false;
    }
    corners = { load<Index>(this->At + 1), load<Index>(this->At + 5), load<Index>(this->At + 9) };
    return true;
  }

  std::uint64_t left(PlyType type) const
  {
    return static_cast<std::uint64_t>(this->Data.end() - this->At) / plySize(type);
  }

  std::uint64_t leastSize(const PlyElement& element) const
  {
    std::uint64_t size = 0;
    for (const PlyProperty& property : element.properties)
    {
      size += plySize(property.isList ? property.countType : property.type);
    }
    return size;
  }

  [[noreturn]] void fail(const std::string& what) const { this->Data.failAtByte(this->At, what); }

private:
  template <class T>
  T take()
  {
    if (!this->hasBytes(sizeof(T)))
    {
      this->failAtEnd();
    }
    this->At += sizeof(T);
    return load<T>(this->At - sizeof(T));
  }

  template <class T>
  static T load(const char* at)
  {
    char raw[sizeof(T)];
    std::memcpy(raw, at, sizeof(T));
    if constexpr (Order != std::endian::native)
    {
      std::reverse(raw, raw + sizeof(T));
    }
    T value;
    std::memcpy(&value, raw, sizeof(T));
    return value;
  }

  [[noreturn]] void failAtEnd() const { this->fail("the file ends too early; it is truncated"); }

  const Source& Data;
  const char* At;
};

} // namespace scan
