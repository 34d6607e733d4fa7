// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/model.h"

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace scan
{

/// The columns behind x y z of a line of text, up to kMost of them.
struct FurtherColumns
{
  static constexpr std::size_t kMost = 12;

  std::array<double, kMost> values = {}; ///< NaN where a column is no number
  std::size_t count = 0;                 ///< of all of them
};

/// Reads up to `most` columns of the line from `at` on, which is behind z, up to a comment or the
/// end of the line, and leaves `at` behind them; count is at most one more than `most`.
FurtherColumns readFurtherColumns(const char*& at, const char* end, std::size_t most);

/// What the columns behind x y z hold, in all lines of a list.
struct PointColumns
{
  static constexpr std::size_t kNone = FurtherColumns::kMost;

  std::size_t color = kNone;  ///< the column of red, counted from 0 behind z
  std::size_t normal = kNone; ///< the column of nx
  double colorScale = 1.0;    ///< what makes channels of 0 to 255 of the numbers

  bool hasColors() const { return this->color != kNone; }
  bool hasNormals() const { return this->normal != kNone; }

  /// How many columns have to be read.
  std::size_t count() const;

  /// White where the columns are not three numbers of that range.
  Color colorOf(const FurtherColumns& columns) const;

  /// Of length 1, or 0 0 0 where the columns are not three numbers.
  Vec3 normalOf(const FurtherColumns& columns) const;
};

/// The words of a line, in lower case and without what starts a comment or quotes, when x, y and z
/// are among them: it may name the columns. Else empty.
std::vector<std::string> readColumnNames(const char* line, const char* end);

/// The number of columns of a line.
std::size_t countColumns(const char* line, const char* end);

/// What columns of these names, which are those behind z, hold: r g b or red green blue of 0 to 255
/// or 0 to 1, rf gf bf of 0 to 1, nx ny nz of any length. Not when most of the lines disagree.
PointColumns findColumns(
  std::span<const std::string> names, const std::vector<FurtherColumns>& lines);

/// Finds out what columns hold from those of the first lines, as readers/points_text.h says.
PointColumns guessColumns(const std::vector<FurtherColumns>& lines);

} // namespace scan
