// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/pts.h"

#include "filters/base/error.h"
#include "readers/scan_lines.h"
#include "readers/text_scanner.h"

#include <cmath>

namespace scan
{
namespace
{

constexpr double kLargestCount = 1e15;

bool isCount(const LineColumns& line)
{
  const double count = line.values[0];
  return line.count == 1 && line.isNumeric && count >= 0.0 && count <= kLargestCount &&
    count == std::trunc(count);
}

} // namespace

Model parsePts(std::span<const char> bytes, std::string_view name, Execution& execution)
{
  const Source source{ name, bytes };
  ScanLineReader reader(source, execution);
  const char* const end = source.end();
  const char* at = skipBlankLines(skipByteOrderMark(source), end);
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
    std::uint64_t ignored = 0;
    at = reader.readScan(at, nullptr, ignored);
  } while (at != end);
  return reader.finish();
}

bool looksLikePts(std::span<const char> head)
{
  const Source source{ "head", head };
  try
  {
    const LineColumns first =
      readColumns(skipBlankLines(skipByteOrderMark(source), source.end()), source.end());
    const LineColumns second =
      readColumns(skipBlankLines(nextLine(first.end, source.end()), source.end()), source.end());
    return isCount(first) && second.isNumeric &&
      (second.count == 4 || second.count == 6 || second.count == 7);
  }
  catch (const Error&)
  {
    return false;
  }
}

} // namespace scan
