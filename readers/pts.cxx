// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/pts.h"

#include "filters/base/error.h"
#include "readers/point_columns.h"
#include "readers/scan_lines.h"
#include "readers/text_scanner.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace scan
{
namespace
{

constexpr int kInspectedPoints = 100;

} // namespace

Model parsePts(std::span<const char> bytes, std::string_view name, Execution& execution)
{
  const Source source = textOf(name, bytes);
  ScanLineReader reader(source, execution);
  const char* const end = source.end();
  const char* at = skipBlankLines(skipByteOrderMark(source), end);
  std::uint64_t announced = 0;
  std::uint64_t found = 0;
  do
  {
    const LineColumns line = readColumns(at, end);
    if (!isCount(line))
    {
      source.failAtLine(at,
        "expected the number of points, found " +
          quoted({ at, static_cast<std::size_t>(line.end - at) }));
    }
    at = nextLine(line.end, end);
    reader.expect(static_cast<std::uint64_t>(line.values[0]), at);
    std::uint64_t lines = 0;
    at = reader.readScan(at, nullptr, lines);
    announced += static_cast<std::uint64_t>(line.values[0]);
    found += lines;
  } while (at != end);
  Model model = reader.finish();
  model.addNote(found < announced ? "the file announces " + std::to_string(announced) +
        " points, but has " + std::to_string(found) + "; it may be truncated"
                                  : "");
  return model;
}

bool looksLikePts(std::span<const char> head)
{
  const char* const end = head.data() + head.size();
  const char* const start = skipBlankLines(skipUtf8Mark(head), end);
  for (const char* line = skipUtf8Mark(head); line < start; line = nextLine(line, end))
  {
    if (!readColumnNames(line, end).empty())
    {
      return false; // a vertex list, whose reader makes use of the names
    }
  }
  const LineColumns count = readColumns(start, end);
  bool hasColors = false; // that cannot be normals, which other lists with a count have
  int columns = 0;
  const char* at = skipBlankLines(nextLine(count.end, end), end);
  for (int i = 0; i < kInspectedPoints && at != end; ++i)
  {
    const LineColumns line = readColumns(at, end);
    if (columns > 0 && (line.end == end || isCount(line))) // it may be cut off; the next scan
    {
      break;
    }
    const bool isSame = columns == 0 || columns == line.count;
    columns = line.count;
    const auto* const color = line.values.data() + (columns >= 7 ? 4 : 3);
    const bool isInteger =
      std::all_of(color, color + 3, [](double v) { return v == std::trunc(v); });
    if (!isSame || !isScanLine(line) || (columns > 4 && !isInteger))
    {
      return false;
    }
    hasColors = hasColors || std::hypot(color[0], color[1], color[2]) != 1.0;
    at = skipBlankLines(nextLine(line.end, end), end);
  }
  return isCount(count) && columns > 0 && (columns <= 4 || hasColors);
}

} // namespace scan
