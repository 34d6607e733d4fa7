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

bool isInteger(const Vec3& v)
{
  return v.x == std::trunc(v.x) && v.y == std::trunc(v.y) && v.z == std::trunc(v.z);
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
  if (columns.count < this->color + 3)
  {
    return kNoColor;
  }
  const Vec3 found = vectorAt(columns, this->color) * this->colorScale;
  const bool isColor = isChannel(found.x) && isChannel(found.y) && isChannel(found.z);
  return isColor ? Color{ toChannel(found.x), toChannel(found.y), toChannel(found.z) } : kNoColor;
}

Vec3 PointColumns::normalOf(const FurtherColumns& columns) const
{
  const bool isThere = columns.count >= this->normal + 3;
  return isThere ? unitOrZero(vectorAt(columns, this->normal)) : Vec3{};
}

std::vector<std::string> readColumnNames(const char* line, const char* end)
{
  std::vector<std::string> names;
  const auto isGap = [](char c) { return isSeparator(c) || isMark(c); };
  const char* const stop = findLineEnd(line, end);
  std::size_t count = 0; // growing would take three times the memory, for lines without an end
  for (const char* at = line; at != stop; ++at)
  {
    count += !isGap(*at) && (at == line || isGap(at[-1])) ? 1 : 0;
  }
  names.reserve(count);
  while (line != stop)
  {
    const char* const start = std::find_if_not(line, stop, isGap);
    line = std::find_if(start, stop, isGap);
    if (start != line)
    {
      names.push_back(lowerCase({ start, static_cast<std::size_t>(line - start) }));
    }
  }
  for (const char* const axis : { "x", "y", "z" })
  {
    if (std::ranges::find(names, axis) == names.end())
    {
      return {};
    }
  }
  return names;
}

std::size_t countColumns(const char* line, const char* end)
{
  std::size_t count = 0;
  for (line = skipBlanks(line, end); line != end && !isLineEnd(*line) && !isComment(line, end);
       line = skipSeparator(line, end))
  {
    line = std::find_if(line, end, [](char c) { return isSeparator(c) || isLineEnd(c); });
    ++count;
  }
  return count;
}

PointColumns findColumns(
  std::span<const std::string> names, const std::vector<FurtherColumns>& lines)
{
  const auto columnOf = [&](const std::array<const char*, 3>& triple)
  {
    const auto found = std::search(names.begin(), names.end(), triple.begin(), triple.end());
    const auto column = static_cast<std::size_t>(found - names.begin());
    return found != names.end() && column + 3 <= FurtherColumns::kMost ? column
                                                                       : PointColumns::kNone;
  };
  // in the range 0 to `most`, or anywhere, in most of the lines
  const auto isUsual = [&](std::size_t column, double least, double most)
  {
    const auto agrees = [&](const FurtherColumns& line)
    {
      const Vec3 v = column + 3 <= line.count ? vectorAt(line, column) : Vec3{ NAN, NAN, NAN };
      return std::min({ v.x, v.y, v.z }) >= least && std::max({ v.x, v.y, v.z }) <= most;
    };
    return column != PointColumns::kNone &&
      2 * std::ranges::count_if(lines, agrees) >= static_cast<std::ptrdiff_t>(lines.size());
  };
  const std::size_t real = columnOf({ "rf", "gf", "bf" });
  const std::size_t color =
    std::min(columnOf({ "r", "g", "b" }), columnOf({ "red", "green", "blue" }));
  const std::size_t normal = columnOf({ "nx", "ny", "nz" });
  const bool isFraction = isUsual(color, 0.0, 1.0) &&
    std::ranges::any_of(
      lines, [&](const FurtherColumns& line) { return !isInteger(vectorAt(line, color)); });
  PointColumns columns;
  if (isUsual(color, 0.0, 255.0))
  {
    columns.color = color;
    columns.colorScale = isFraction ? 255.0 : 1.0;
  }
  else if (isUsual(real, 0.0, 1.0))
  {
    columns.color = real;
    columns.colorScale = 255.0;
  }
  constexpr double kLargest = std::numeric_limits<double>::max();
  columns.normal = isUsual(normal, -kLargest, kLargest) ? normal : PointColumns::kNone;
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
