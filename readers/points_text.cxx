// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/points_text.h"

#include "filters/base/error.h"
#include "readers/coordinate_check.h"
#include "readers/point_columns.h"
#include "readers/text_columns.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace scan
{
namespace
{

constexpr std::size_t kChunkBytes = std::size_t(1) << 18U; // text and points fit the cache
constexpr std::size_t kChunksPerThread = 8;
constexpr std::size_t kShortestLine = 6;   // "0 0 0\n"
constexpr std::size_t kGuessPoints = 1000; // that tell what further columns hold

/// What a line holds, from its start.
enum class LineKind
{
  point,
  skip,  // blank or comment
  words, // starts with a word
  count, // one number
  broken
};

/// The points of one part of the text, or where it stops being a list of points.
struct Chunk
{
  const char* begin = nullptr;
  const char* end = nullptr;
  std::vector<Vec3> points;
  std::vector<Color> colors;
  std::vector<Vec3> normals;
  CoordinateCheck check;
  const char* broken = nullptr;
};

/// Whether commas separate some of the first columns, which end there, and others do not.
bool hasCommaAndOther(const char* x, const char* y, const char* z, const char* end)
{
  const bool isLast = z == end || isLineEnd(*z);
  const bool hasComma = *x == ',' || *y == ',' || (!isLast && *z == ',');
  return hasComma && !(*x == ',' && *y == ',' && (isLast || *z == ','));
}

/// "1,5;2,5;3,5" would silently become the point 1 5 2.
bool hasDecimalCommas(const char* line, const char* end)
{
  int columns = 0;
  bool hasComma = false;
  while (columns < 3)
  {
    line = std::find_if_not(line, end, [](char c) { return isBlank(c) || c == ';'; });
    const char* const stop =
      std::find_if(line, end, [](char c) { return isBlank(c) || c == ';' || isLineEnd(c); });
    const std::string_view column(line, static_cast<std::size_t>(stop - line));
    const std::size_t comma = column.find(',');
    if (column.empty() || column.find_first_not_of("+-0123456789eE,.") != column.npos ||
      (comma != column.npos &&
        (column.find(',', comma + 1) != column.npos || comma == 0 || comma + 1 == column.size())))
    {
      return false;
    }
    hasComma = hasComma || comma != column.npos;
    line = stop;
    ++columns;
  }
  return hasComma;
}

/// Behind the columns ahead of x, as far as there are such on the line.
const char* skipColumns(const char* at, const char* end, std::size_t count)
{
  for (; count > 0 && at != end && !isLineEnd(*at); --count)
  {
    at = std::find_if(at, end, [](char c) { return isSeparator(c) || isLineEnd(c); });
    at = skipSeparator(at, end);
  }
  return at;
}

/// Reads the line at `at`, which is not the end, and leaves `at` in it, behind what was read.
/// @param ahead the number of columns ahead of x
LineKind readLine(const char*& at, const char* end, std::size_t ahead, Vec3& point)
{
  at = skipBlanks(at, end);
  if (at == end || isLineEnd(*at) || isComment(at, end))
  {
    return LineKind::skip;
  }
  if (*at == 'p' && at + 1 != end && isBlank(at[1]))
  {
    at = skipBlanks(at + 1, end);
  }
  at = skipColumns(at, end, ahead);
  const char* const x = parseColumn(at, end, point.x);
  if (x == nullptr)
  {
    const bool isNumber = at != end && (isDigit(*at) || *at == '-' || *at == '+' || *at == '.');
    return isNumber ? LineKind::broken : LineKind::words;
  }
  const char* const second = skipSeparator(x, end);
  if (second == end || isLineEnd(*second))
  {
    return LineKind::count;
  }
  const char* const y = parseColumn(second, end, point.y);
  const char* const z = y != nullptr ? parseColumn(skipSeparator(y, end), end, point.z) : nullptr;
  const bool mixesCommas = z != nullptr && hasCommaAndOther(x, y, z, end);
  if (z == nullptr || (mixesCommas && hasDecimalCommas(at, end)))
  {
    return LineKind::broken;
  }
  at = z;
  return LineKind::point;
}

[[noreturn]] void failAtBrokenLine(const Source& source, const char* at)
{
  const char* const end = findLineEnd(at, source.end());
  if (hasDecimalCommas(at, source.end()))
  {
    source.failAtLine(at, "the numbers have decimal commas; export them with decimal points");
  }
  source.failAtLine(at,
    "expected x y z, found " + quoted({ at, static_cast<std::size_t>(end - at) }) +
      "; correct or remove the line");
}

/// Where the points start, and what the header says about them.
struct Start
{
  const char* points = nullptr;
  std::vector<std::string> names; // of all columns; empty when the header does not say
  std::size_t ahead = 0;          // columns ahead of x

  std::span<const std::string> furtherNames() const
  {
    return std::span(this->names).subspan(this->names.empty() ? 0 : this->ahead + 3);
  }
};

/// The number of columns ahead of x. Throws Error parse when y and z do not follow.
std::size_t columnsAhead(
  const Source& source, const char* line, const std::vector<std::string>& names)
{
  const auto x = std::ranges::find(names, "x");
  if (names.end() - x < 3 || x[1] != "y" || x[2] != "z")
  {
    source.failAtLine(
      line, "the columns of x, y and z do not follow each other in this order; export them so");
  }
  return static_cast<std::size_t>(x - names.begin());
}

Start skipHeader(const Source& source)
{
  Start start;
  const char* header = nullptr; // the last line that may name the columns
  const char* const end = source.end();
  for (const char* line = skipByteOrderMark(source); line != end; line = nextLine(line, end))
  {
    // words in a sentence are hardly as many as the columns
    const bool isNamed = header != nullptr && countColumns(line, end) == start.names.size();
    start.ahead = isNamed ? columnsAhead(source, header, start.names) : 0;
    const char* at = line;
    Vec3 point;
    const LineKind kind = readLine(at, end, start.ahead, point);
    if (kind == LineKind::point)
    {
      start.points = line;
      start.names = isNamed ? std::move(start.names) : std::vector<std::string>();
      return start;
    }
    std::vector<std::string> names = readColumnNames(line, end);
    if (!names.empty())
    {
      header = line;
      start.names = std::move(names);
    }
    else if (kind == LineKind::broken)
    {
      failAtBrokenLine(source, line);
    }
  }
  source.fail("no point found; a vertex list has lines that start with three numbers");
}

/// Whether a line is neither a point nor one that may stand between points.
bool isBroken(LineKind kind, bool isLettered)
{
  return kind != LineKind::point && kind != LineKind::skip &&
    !(isLettered && kind == LineKind::words);
}

/// What the columns of the points hold.
PointColumns findColumns(const Start& start, const char* end, bool isLettered)
{
  std::vector<FurtherColumns> lines;
  const char* at = start.points;
  const char* const stop = at + std::min<std::ptrdiff_t>(end - at, kChunkBytes);
  while (at < stop && lines.size() < kGuessPoints)
  {
    Vec3 ignored;
    const LineKind kind = readLine(at, end, start.ahead, ignored);
    if (kind == LineKind::point)
    {
      lines.push_back(readFurtherColumns(at, end, FurtherColumns::kMost));
    }
    else if (isBroken(kind, isLettered))
    {
      break;
    }
    at = nextLine(at, end);
  }
  return start.names.empty() ? guessColumns(lines) : findColumns(start.furtherNames(), lines);
}

/// Reads the columns behind z and moves `at` behind them.
void readAttributes(Chunk& chunk, const char*& at, const PointColumns& columns)
{
  const FurtherColumns further = readFurtherColumns(at, chunk.end, columns.count());
  if (columns.hasColors())
  {
    chunk.colors.push_back(columns.colorOf(further));
  }
  if (columns.hasNormals())
  {
    chunk.normals.push_back(columns.normalOf(further));
  }
}

/// Never throws: the storage is reserved.
void readChunk(Chunk& chunk, const Start& start, bool isLettered, const PointColumns& columns)
{
  const bool hasAttributes = columns.count() > 0;
  const char* at = chunk.begin;
  while (at != chunk.end)
  {
    const char* const line = at;
    Vec3 point;
    LineKind kind = readLine(at, chunk.end, start.ahead, point);
    if (start.ahead > 0 && countColumns(line, chunk.end) != start.names.size())
    {
      kind =
        kind == LineKind::skip ? kind : LineKind::broken; // a name of two words shifts the rest
    }
    if (kind == LineKind::point)
    {
      chunk.points.push_back(point);
      chunk.check.see(point, line);
      if (hasAttributes)
      {
        readAttributes(chunk, at, columns);
      }
    }
    else if (isBroken(kind, isLettered))
    {
      chunk.broken = line;
      return;
    }
    at = nextLine(at, chunk.end);
  }
}

/// Makes the chunk the whole lines from `at` on, about kChunkBytes; its storage is kept.
void cutChunk(Chunk& chunk, const char* at, const char* end, const PointColumns& columns)
{
  const auto rest = static_cast<std::size_t>(end - at);
  chunk.begin = at;
  chunk.end = rest > kChunkBytes ? nextLine(at + kChunkBytes, end) : end;
  const std::size_t most = static_cast<std::size_t>(chunk.end - at) / kShortestLine + 1;
  chunk.points.clear();
  chunk.points.reserve(most);
  chunk.colors.clear();
  chunk.colors.reserve(columns.hasColors() ? most : 0);
  chunk.normals.clear();
  chunk.normals.reserve(columns.hasNormals() ? most : 0);
  chunk.check = {};
}

/// Copies the points of the next chunk behind those of the model.
void append(Model& model, const Chunk& chunk)
{
  model.points.insert(model.points.end(), chunk.points.begin(), chunk.points.end());
  model.colors.insert(model.colors.end(), chunk.colors.begin(), chunk.colors.end());
  model.normals.insert(model.normals.end(), chunk.normals.begin(), chunk.normals.end());
}

std::size_t countCharacter(const char* begin, const char* end, char wanted)
{
  std::size_t total = 0;
  while (begin != end)
  {
    // a block whose count fits a byte: many times faster than counting in words
    const char* const stop = begin + std::min<std::ptrdiff_t>(end - begin, 192);
    std::uint8_t count = 0;
    for (; begin != stop; ++begin)
    {
      count = static_cast<std::uint8_t>(count + (*begin == wanted));
    }
    total += count;
  }
  return total;
}

/// Upper bound for the number of points; exact for plain lists.
std::size_t countLines(const char* begin, const char* end)
{
  const auto bytes = static_cast<std::size_t>(end - begin);
  const std::size_t feeds = countCharacter(begin, end, '\n');
  const std::size_t lines = feeds > 0 ? feeds : countCharacter(begin, end, '\r');
  return std::min(lines, bytes / kShortestLine) + 1;
}

} // namespace

Model parsePointsText(std::span<const char> bytes, std::string_view name, Execution& execution)
{
  const Source source = textOf(name, bytes);
  const Start start = skipHeader(source);
  const char* at = start.points;
  const bool isLettered = *skipBlanks(at, source.end()) == 'p';
  const PointColumns columns = findColumns(start, source.end(), isLettered);
  Model model;
  const std::size_t most = countLines(at, source.end());
  model.points.reserve(most);
  model.colors.reserve(columns.hasColors() ? most : 0);
  model.normals.reserve(columns.hasNormals() ? most : 0);
  CoordinateCheck check;
  std::vector<Chunk> chunks(execution.threads() * kChunksPerThread);
  while (at != source.end())
  {
    execution.step("read", static_cast<std::size_t>(at - source.begin()), bytes.size());
    for (Chunk& chunk : chunks)
    {
      cutChunk(chunk, at, source.end(), columns);
      at = chunk.end;
    }
    execution.parallelFor(chunks.size(), 1,
      [&](std::size_t begin, std::size_t end)
      {
        std::for_each(chunks.data() + begin, chunks.data() + end,
          [&](Chunk& chunk) { readChunk(chunk, start, isLettered, columns); });
      });
    for (const Chunk& chunk : chunks)
    {
      if (chunk.broken != nullptr)
      {
        failAtBrokenLine(source, chunk.broken);
      }
      append(model, chunk);
      check.append(chunk.check);
    }
  }
  source.checkPointCount(model.points.size());
  check.finish(source, model, CoordinateCheck::Place::line);
  return model;
}

bool looksLikePointsText(std::span<const char> head)
{
  const Source text = textOf("head", head);
  const bool isBinary = std::find(text.begin(), text.end(), '\0') != text.end();
  try
  {
    return !isBinary && skipHeader(text).points != nullptr;
  }
  catch (const Error&)
  {
    return false;
  }
}

} // namespace scan
