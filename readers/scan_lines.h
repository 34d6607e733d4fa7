// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/model.h"
#include "readers/coordinate_check.h"

#include <array>
#include <cstdint>

/// The lines of points that PTS and PTX share: x y z, an intensity and a colour of 0 to 255.
namespace scan
{

/// The numbers at the start of a line.
struct LineColumns
{
  static constexpr int kMost = 7;

  std::array<double, kMost> values = {};
  int count = 0;             ///< of the columns, those behind the last value included
  bool isNumeric = true;     ///< whether all of the values are numbers
  const char* end = nullptr; ///< the end of the line
};

/// Splits the line at `at` at its blanks; none in a comment.
LineColumns readColumns(const char* at, const char* end);

/// Whether the line is a number of points, columns or rows: an integer of 32 bits.
bool isCount(const LineColumns& line);

/// Whether the line can be a point: x y z, x y z intensity, or r g b of 0 to 255 behind either.
bool isScanLine(const LineColumns& line);

/// The start of the next line that is neither blank nor a comment, or the end.
const char* skipBlankLines(const char* at, const char* end);

/// Where a scanner stood: the rows of a 4x4 matrix that a point (x y z 1) is multiplied with from
/// the left, without the last column.
using ScanPlacement = std::array<Vec3, 4>;

/// Reads scans into one model, in the order of the file.
class ScanLineReader
{
public:
  ScanLineReader(const Source& source, Execution& execution);
  ~ScanLineReader();

  /// Makes room for the points of the next scan, no more than can be in the rest of the file.
  void expect(std::uint64_t count, const char* at);

  /// Reads the points from `at` on up to the next line of one column or the end of the file.
  ///
  /// Lines have the columns x y z, x y z intensity, x y z r g b or x y z intensity r g b (what
  /// follows is skipped), the same in all lines of the scan. Throws Error parse, with the line, for
  /// any other.
  /// @param placement moves the points, and points at 0 0 0, the voids, are left out; may be null
  /// @param[out] lines number of points in the file, voids included
  /// @return the line where the scan ends, or the end of the file
  const char* readScan(const char* at, const ScanPlacement* placement, std::uint64_t& lines);

  /// The model. Points of scans without colours are white beside those of scans with colours.
  /// Throws Error parse for coordinates that are not finite or exceed 1e50 and for a file without a
  /// point; Error limit for 2^32 - 1 points.
  Model finish();

private:
  struct Chunk;

  const char* readBatch(
    const char* at, std::size_t bytes, int columns, const ScanPlacement* placement);
  void append(const Chunk& chunk);

  const Source& Text;
  Execution& Run;
  Model Result;
  CoordinateCheck Check;
  std::vector<Chunk> Chunks;
  std::uint64_t Lines = 0; // of the scan
  bool IsScanEnd = false;
};

} // namespace scan
