// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/point_columns.h"

#include "readers/point_attributes.h"
#include "readers/text_columns.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>

namespace scan
{
namespace
{

constexpr double kUnitTolerance = 0.02; // normals of two decimals

bool isByte(double value)
{
  return isChannel(value) && value == std::trunc(value);
}

bool isColor(const FurtherColumns& line, std::size_t column)
{
  const auto& v = line.values;
  return isByte(v[column]) && isByte(v[column + 1]) && isByte(v[column + 2]);
}

Vec3 vectorAt(const FurtherColumns& line, std::size_t column)
{
  return { line.values[column], line.values[column + 1], line.values[column + 2] };
}

/// Of length 1, or 0 0 0, which programs write for points without a normal.
bool isNormal(const FurtherColumns& line, std::size_t column)
{
  const Vec3 v = vectorAt(line, column);
  return v == Vec3{} || std::abs(std::hypot(v.x, v.y, v.z) - 1.0) <= kUnitTolerance;
}

/// What starts a comment or quotes a name.
bool isMark(char c)
{
  return c == '/' || c == '#' || c == '!' || c == '%' || c == '"';
}

bool isNumeric(const FurtherColumns& line)
{
  return std::none_of(
    line.values.begin(), line.values.end(), [](double v) { return std::isnan(v); });
}

using Lines = std::vector<FurtherColumns>;

template <class Test>
bool isInAll(const Lines& lines, const Test& test)
{
  return std::all_of(lines.begin(), lines.end(), test);
}

/// Whether not all lines have the same number there.
bool varies(const Lines& lines, std::size_t column)
{
  return !isInAll(lines,
    [&](const FurtherColumns& line)
    { return line.values[column] == lines.front().values[column]; });
}

PointColumns guessThree(const Lines& lines)
{
  const bool isZero =
    isInAll(lines, [](const FurtherColumns& line) { return vectorAt(line, 0) == Vec3{}; });
  if (isZero) // black, or no normals
  {
    return {};
  }
  if (isInAll(lines, [](const FurtherColumns& line) { return isNormal(line, 0); }))
  {
    return { .normal = 0 };
  }
  const bool isColored =
    isInAll(lines, [](const FurtherColumns& line) { return isColor(line, 0); });
  return isColored ? PointColumns{ .color = 0 } : PointColumns{};
}

PointColumns guessFour(const Lines& lines)
{
  if (!isInAll(lines, [](const FurtherColumns& line) { return isColor(line, 1); }))
  {
    return {};
  }
  const bool isOpaque = isInAll(lines,
    [](const FurtherColumns& line) { return isByte(line.values[0]) && line.values[3] == 255; });
  if (!isOpaque)
  {
    return { .color = 1 };
  }
  // an opacity: blue alone would not be 255 in all lines
  return varies(lines, 1) && varies(lines, 2) ? PointColumns{ .color = 0 } : PointColumns{};
}

PointColumns guessSix(const Lines& lines)
{
  const bool hasBoth = isInAll(
    lines, [](const FurtherColumns& line) { return isColor(line, 0) && isNormal(line, 3); });
  return hasBoth ? PointColumns{ .color = 0, .normal = 3 } : PointColumns{};
}

} // namespace

FurtherColumns readFurtherColumns(const char*& at, const char* end, std::size_t most)
{
  FurtherColumns columns;
  for (;;)
  {
    at = skipSeparator(at, end);
    if (at == end || isLineEnd(*at) || isComment(at, end) || columns.count > most)
    {
      return columns;
    }
    if (columns.count < most)
    {
      double& value = columns.values[columns.count];
      const char* const stop = parseColumn(at, end, value);
      value = stop != nullptr ? value : std::numeric_limits<double>::quiet_NaN();
      at = stop != nullptr ? stop : at;
    }
    ++columns.count;
    while (!isColumnEnd(at, end))
    {
      ++at;
    }
  }
}

std::size_t PointColumns::count() const
{
  return std::max(
    this->hasColors() ? this->color + 3 : 0, this->hasNormals() ? this->normal + 3 : 0);
}

Color PointColumns::colorOf(const FurtherColumns& columns) const
{
  if (columns.count < this->color + 3 || !isColor(columns, this->color))
  {
    return kNoColor;
  }
  const Vec3 found = vectorAt(columns, this->color);
  return { toChannel(found.x), toChannel(found.y), toChannel(found.z) };
}

Vec3 PointColumns::normalOf(const FurtherColumns& columns) const
{
  const bool isThere = columns.count >= this->normal + 3;
  return isThere ? unitOrZero(vectorAt(columns, this->normal)) : Vec3{};
}

std::vector<std::string> readColumnNames(const char* line, const char* end)
{
  std::vector<std::string> names;
  const char* const stop = findLineEnd(line, end);
  while (line != stop)
  {
    const char* const start =
      std::find_if_not(line, stop, [](char c) { return isSeparator(c) || isMark(c); });
    line = std::find_if(start, stop, [](char c) { return isSeparator(c) || isMark(c); });
    if (start != line)
    {
      names.push_back(lowerCase({ start, static_cast<std::size_t>(line - start) }));
    }
  }
  const bool isHeader = names.size() > 3 && names[0] == "x" && names[1] == "y" && names[2] == "z";
  names.erase(names.begin(), isHeader ? names.begin() + 3 : names.end());
  return names;
}

PointColumns findColumns(
  const std::vector<std::string>& names, const std::vector<FurtherColumns>& lines)
{
  const auto columnOf = [&](const std::array<const char*, 3>& triple)
  {
    const auto found = std::search(names.begin(), names.end(), triple.begin(), triple.end());
    const auto column = static_cast<std::size_t>(found - names.begin());
    return found != names.end() && column + 3 <= FurtherColumns::kMost ? column
                                                                       : PointColumns::kNone;
  };
  PointColumns columns;
  columns.color = std::min(columnOf({ "r", "g", "b" }), columnOf({ "red", "green", "blue" }));
  columns.normal = columnOf({ "nx", "ny", "nz" });
  for (const FurtherColumns& line : lines)
  {
    const bool isComplete = line.count >= columns.count();
    const bool hasColor = columns.hasColors() && isComplete && isColor(line, columns.color);
    const bool hasNormal = columns.hasNormals() && isComplete && isNormal(line, columns.normal);
    columns.color = hasColor || !isComplete ? columns.color : PointColumns::kNone;
    columns.normal = hasNormal || !isComplete ? columns.normal : PointColumns::kNone;
  }
  return columns;
}

PointColumns guessColumns(const std::vector<FurtherColumns>& lines)
{
  std::size_t most = 0;
  for (const FurtherColumns& line : lines)
  {
    most = std::max(most, line.count);
  }
  Lines full; // others miss what these have
  std::copy_if(lines.begin(), lines.end(), std::back_inserter(full),
    [&](const FurtherColumns& line) { return line.count == most && isNumeric(line); });
  switch (full.empty() ? 0 : most)
  {
    case 3:
      return guessThree(full);
    case 4:
      return guessFour(full);
    case 6:
      return guessSix(full);
    default:
      return {};
  }
}

} // namespace scan
