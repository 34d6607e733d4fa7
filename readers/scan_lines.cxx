// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/scan_lines.h"

#include "filters/base/error.h"
#include "readers/point_attributes.h"
#include "readers/text_columns.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace scan
{
namespace
{

constexpr std::size_t kChunkBytes = std::size_t(1) << 18U; // text and points fit the cache
constexpr std::size_t kChunksPerThread = 8;
constexpr std::size_t kFirstBatchBytes = 512;
constexpr std::size_t kShortestLine = 6; // "0 0 0\n"

/// Whether lines of a scan can have so many columns.
bool isLayout(int columns)
{
  return columns == 3 || columns == 4 || columns >= 6;
}

/// The column of red; 0 when there is none.
std::size_t colorColumn(int columns)
{
  return columns >= 7 ? 4 : columns == 6 ? 3 : 0;
}

/// Whether the columns from `red` on are a colour; true without them.
bool hasColor(const LineColumns& line, std::size_t red)
{
  const auto& v = line.values;
  return red == 0 || (isChannel(v[red]) && isChannel(v[red + 1]) && isChannel(v[red + 2]));
}

Vec3 placed(const Vec3& p, const ScanPlacement& placement)
{
  return placement[0] * p.x + placement[1] * p.y + placement[2] * p.z + placement[3];
}

} // namespace

LineColumns readColumns(const char* at, const char* end)
{
  LineColumns line;
  at = skipBlanks(at, end);
  if (at != end && isComment(at, end))
  {
    line.end = findLineEnd(at, end);
    return line;
  }
  for (; at != end && !isLineEnd(*at); at = skipBlanks(at, end))
  {
    const char* stop = nullptr;
    if (line.count < LineColumns::kMost)
    {
      stop = parseNumber(at, end, line.values[static_cast<std::size_t>(line.count)]);
      const bool isNumber = stop != nullptr && (stop == end || isBlank(*stop) || isLineEnd(*stop));
      line.isNumeric = line.isNumeric && isNumber;
      stop = isNumber ? stop : nullptr;
    }
    ++line.count;
    at = stop != nullptr ? stop : at + word(at, end).size();
  }
  line.end = at;
  return line;
}

const char* skipBlankLines(const char* at, const char* end)
{
  for (;;)
  {
    const char* const first = skipBlanks(at, end);
    if (first == end || !(isLineEnd(*first) || isComment(first, end)))
    {
      return first == end ? end : at;
    }
    at = nextLine(first, end);
  }
}

bool isCount(const LineColumns& line)
{
  constexpr double kLargest = 4294967295.0; // the product of two fits 64 bits
  const double count = line.values[0];
  return line.count == 1 && line.isNumeric && count >= 0.0 && count <= kLargest &&
    count == std::trunc(count);
}

bool isScanLine(const LineColumns& line)
{
  return line.isNumeric && line.count <= LineColumns::kMost && isLayout(line.count) &&
    hasColor(line, colorColumn(line.count));
}

/// The points of some lines, or where they stop being points.
struct ScanLineReader::Chunk
{
  const char* begin = nullptr;
  const char* end = nullptr; // behind the last line that was read
  std::vector<Vec3> points;
  std::vector<Color> colors;
  CoordinateCheck check;
  std::uint64_t lines = 0;
  const char* broken = nullptr;
  bool isScanEnd = false;

  /// Takes the whole lines from `at` on, about `bytes` of them; the storage is kept.
  void cut(const char* at, const char* textEnd, std::size_t bytes, bool hasColors)
  {
    const auto rest = static_cast<std::size_t>(textEnd - at);
    this->begin = at;
    this->end = rest > bytes ? nextLine(at + bytes, textEnd) : textEnd;
    const std::size_t most = static_cast<std::size_t>(this->end - at) / kShortestLine + 1;
    this->points.clear();
    this->points.reserve(at != textEnd ? most : 0);
    this->colors.clear();
    this->colors.reserve(at != textEnd && hasColors ? most : 0);
    this->check = {};
    this->lines = 0;
    this->broken = nullptr;
    this->isScanEnd = false;
  }

  /// Never throws: the storage is reserved.
  void read(int columns, const ScanPlacement* placement)
  {
    const std::size_t red = colorColumn(columns);
    for (const char* at = this->begin; at != this->end;)
    {
      const LineColumns line = readColumns(at, this->end);
      if (line.count == 1 && line.isNumeric)
      {
        this->isScanEnd = true;
        this->end = at;
        return;
      }
      const auto& v = line.values;
      const bool isPoint = line.isNumeric && line.count == columns && hasColor(line, red);
      if (line.count != 0 && !isPoint)
      {
        this->broken = at;
        return;
      }
      const Vec3 point = { v[0], v[1], v[2] };
      this->lines += line.count != 0 ? 1 : 0;
      if (line.count != 0 && (placement == nullptr || !(point == Vec3{})))
      {
        this->points.push_back(placement != nullptr ? placed(point, *placement) : point);
        this->check.see(this->points.back(), at);
        if (red != 0)
        {
          this->colors.push_back(
            { toChannel(v[red]), toChannel(v[red + 1]), toChannel(v[red + 2]) });
        }
      }
      at = nextLine(line.end, this->end);
    }
  }
};

ScanLineReader::ScanLineReader(const Source& source, Execution& execution)
  : Text(source)
  , Run(execution)
  , Chunks(execution.threads() * kChunksPerThread)
{
}

ScanLineReader::~ScanLineReader() = default;

void ScanLineReader::expect(std::uint64_t count, const char* at)
{
  const auto left = static_cast<std::uint64_t>(this->Text.end() - at);
  const std::uint64_t needed =
    this->Result.points.size() + std::min(count, left / kShortestLine + 1);
  if (needed > this->Result.points.capacity())
  {
    // at least twice as many, or a file of many small scans is copied for each of them
    this->Result.points.reserve(std::max<std::size_t>(needed, 2 * this->Result.points.capacity()));
  }
}

const char* ScanLineReader::readScan(
  const char* at, const ScanPlacement* placement, std::uint64_t& lines)
{
  this->Lines = 0;
  this->IsScanEnd = false;
  at = skipBlankLines(at, this->Text.end());
  const LineColumns first = readColumns(at, this->Text.end());
  const bool isCount = first.count == 1 && first.isNumeric;
  if (at != this->Text.end() && !isCount && !isLayout(first.count))
  {
    this->Text.failAtLine(at,
      "expected x y z, perhaps an intensity and r g b, found " +
        quoted({ at, static_cast<std::size_t>(first.end - at) }));
  }
  // Batches grow, so that little is read in vain behind the end of a small scan.
  const std::size_t most = kChunkBytes * this->Chunks.size();
  for (std::size_t bytes = kFirstBatchBytes; at != this->Text.end() && !this->IsScanEnd;
       bytes = std::min(2 * bytes, most))
  {
    this->Run.step(
      "read", static_cast<std::size_t>(at - this->Text.begin()), this->Text.bytes.size());
    at = this->readBatch(at, bytes, first.count, placement);
  }
  lines = this->Lines;
  return at;
}

const char* ScanLineReader::readBatch(
  const char* at, std::size_t bytes, int columns, const ScanPlacement* placement)
{
  const std::size_t count = (bytes + kChunkBytes - 1) / kChunkBytes;
  for (std::size_t i = 0; i < count; ++i)
  {
    this->Chunks[i].cut(
      at, this->Text.end(), std::min(bytes, kChunkBytes), colorColumn(columns) != 0);
    at = this->Chunks[i].end;
  }
  this->Run.parallelFor(count, 1,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        this->Chunks[i].read(columns, placement);
      }
    });
  for (std::size_t i = 0; i < count && !this->IsScanEnd; ++i)
  {
    this->append(this->Chunks[i]);
    at = this->Chunks[i].end;
  }
  return at;
}

void ScanLineReader::append(const Chunk& chunk)
{
  if (chunk.broken != nullptr)
  {
    const char* const end = findLineEnd(chunk.broken, this->Text.end());
    this->Text.failAtLine(chunk.broken,
      "expected numbers in the columns of the lines above, colours from 0 to 255, found " +
        quoted({ chunk.broken, static_cast<std::size_t>(end - chunk.broken) }) +
        "; correct or remove the line");
  }
  std::vector<Vec3>& points = this->Result.points;
  std::vector<Color>& colors = this->Result.colors;
  const std::size_t before = points.size();
  points.insert(points.end(), chunk.points.begin(), chunk.points.end());
  if (!chunk.colors.empty())
  {
    colors.resize(before, kNoColor);
    colors.insert(colors.end(), chunk.colors.begin(), chunk.colors.end());
  }
  this->Check.append(chunk.check);
  this->Lines += chunk.lines;
  this->IsScanEnd = chunk.isScanEnd;
}

Model ScanLineReader::finish()
{
  const std::size_t count = this->Result.points.size();
  this->Text.checkPointCount(count);
  if (count == 0)
  {
    this->Text.fail("no point found; there is nothing to load");
  }
  if (!this->Result.colors.empty())
  {
    this->Result.colors.resize(count, kNoColor);
  }
  this->Check.finish(this->Text, this->Result, CoordinateCheck::Place::line);
  return std::move(this->Result);
}

} // namespace scan
