// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "readers/source.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace scan
{

enum class PlyEncoding
{
  ascii,
  littleEndian,
  bigEndian
};

enum class PlyType
{
  int8,
  uint8,
  int16,
  uint16,
  int32,
  uint32,
  float32,
  float64
};

/// Bytes of a value in the binary encodings.
std::size_t plySize(PlyType type);

struct PlyProperty
{
  std::string name;
  PlyType type = PlyType::float32;
  bool isList = false;
  PlyType countType = PlyType::uint8; ///< of a list
};

struct PlyElement
{
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;

  bool hasList() const;

  /// The property's place in properties; their number when there is none of that name.
  std::size_t find(std::string_view property) const;
};

struct PlyHeader
{
  PlyEncoding encoding = PlyEncoding::ascii;
  std::vector<PlyElement> elements;
  std::uint64_t columns = 0; ///< of the element range_grid, from obj_info; 0 when not given
  std::uint64_t rows = 0;
  std::size_t size = 0; ///< bytes up to the first element's data
};

/// Reads the header; skips lines that are neither format, element, property nor size of a grid.
/// Throws Error parse with the line.
PlyHeader parsePlyHeader(const Source& source);

} // namespace scan
