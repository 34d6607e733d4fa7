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

/// One or more numbers that every point has.
struct PcdField
{
  std::string name;
  std::size_t size = 4;  ///< bytes of a number
  char type = 'F';       ///< F: floating point, I: signed, U: unsigned
  std::size_t count = 1; ///< of the numbers
};

enum class PcdEncoding
{
  ascii,
  binary,
  compressed
};

struct PcdHeader
{
  std::vector<PcdField> fields;
  std::uint64_t points = 0;
  PcdEncoding encoding = PcdEncoding::ascii;
  const char* body = nullptr; ///< behind the header

  /// The index of the field; the number of fields when there is none.
  std::size_t find(std::string_view name) const;

  /// The bytes of a point in a binary body.
  std::size_t pointSize() const;

  /// The numbers of a point.
  std::size_t pointColumns() const;
};

/// Throws Error parse, with the line. The number of points is not held against the body.
PcdHeader parsePcdHeader(const Source& source);

} // namespace scan
