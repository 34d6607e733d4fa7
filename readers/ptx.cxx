// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/ptx.h"

#include "filters/base/error.h"
#include "readers/scan_lines.h"
#include "readers/text_scanner.h"

#include <algorithm>
#include <string>

namespace scan
{
namespace
{

constexpr double kMillimetresPerMetre = 1000.0;
constexpr std::uint64_t kShortestCell = 6; // "0 0 0\n"

/// Reads the headers of the scans in a PTX file.
class PtxReader
{
public:
  PtxReader(const Source& source, Execution& execution)
    : Text(source)
    , Lines(source, execution)
    , At(skipBlankLines(skipByteOrderMark(source), source.end()))
  {
  }

  Model read()
  {
    do
    {
      this->readScan();
    } while (this->At != this->Text.end());
    Model model = this->Lines.finish();
    model.millimetresPerUnit = kMillimetresPerMetre;
    return model;
  }

private:
  void readScan()
  {
    const char* const start = this->At;
    const std::uint64_t columns = this->count("columns");
    const std::uint64_t cells = columns * this->count("rows");
    const auto left = static_cast<std::uint64_t>(this->Text.end() - this->At);
    if (cells > left / kShortestCell + 1)
    {
      this->Text.failAtLine(start,
        "the scan announces " + std::to_string(cells) +
          " cells, more than the file can hold; it is truncated");
    }
    for (int i = 0; i < 4; ++i)
    {
      this->row<3>("the place or an axis of the scanner");
    }
    const ScanPlacement placement = this->matrix();
    this->Lines.expect(cells, this->At);
    std::uint64_t lines = 0;
    this->At = this->Lines.readScan(this->At, &placement, lines);
    if (lines != cells)
    {
      this->Text.failAtLine(start,
        "the scan announces " + std::to_string(cells) + " cells, but " + std::to_string(lines) +
          " lines follow; it is truncated or malformed");
    }
  }

  std::uint64_t count(const char* what)
  {
    const LineColumns line = this->nextRow();
    if (!isCount(line))
    {
      this->failAtRow(line, "the number of " + std::string(what));
    }
    this->At = nextLine(line.end, this->Text.end());
    return static_cast<std::uint64_t>(line.values[0]);
  }

  template <int Size>
  std::array<double, LineColumns::kMost> row(const std::string& what)
  {
    const LineColumns line = this->nextRow();
    if (line.count != Size || !line.isNumeric)
    {
      this->failAtRow(line, std::to_string(Size) + " numbers, " + what);
    }
    this->At = nextLine(line.end, this->Text.end());
    return line.values;
  }

  ScanPlacement matrix()
  {
    ScanPlacement placement;
    for (std::size_t i = 0; i < placement.size(); ++i)
    {
      const char* const start = this->At;
      const auto values = this->row<4>("a row of the matrix");
      if (values[3] != (i < 3 ? 0.0 : 1.0))
      {
        this->Text.failAtLine(start,
          "the last column of the matrix must be 0 0 0 1, with the translation in the last row");
      }
      placement[i] = { values[0], values[1], values[2] };
    }
    return placement;
  }

  LineColumns nextRow()
  {
    this->At = skipBlankLines(this->At, this->Text.end());
    return readColumns(this->At, this->Text.end());
  }

  [[noreturn]] void failAtRow(const LineColumns& line, const std::string& what) const
  {
    this->Text.failAtLine(this->At,
      "expected " + what + ", found " +
        quoted({ this->At, static_cast<std::size_t>(line.end - this->At) }));
  }

  const Source& Text;
  ScanLineReader Lines;
  const char* At;
};

} // namespace

Model parsePtx(std::span<const char> bytes, std::string_view name, Execution& execution)
{
  const Source source = textOf(name, bytes);
  return PtxReader(source, execution).read();
}

bool looksLikePtx(std::span<const char> head)
{
  // columns, rows, the place and the axes of the scanner, a matrix
  static constexpr int kSizes[] = { 1, 1, 3, 3, 3, 3, 4, 4, 4, 4 };
  const char* const end = head.data() + head.size();
  const char* at = skipUtf8Mark(head);
  for (const int size : kSizes)
  {
    const LineColumns line = readColumns(skipBlankLines(at, end), end);
    if (line.count != size || !line.isNumeric || (size == 1 && !isCount(line)))
    {
      return false;
    }
    at = nextLine(line.end, end);
  }
  return true;
}

} // namespace scan
