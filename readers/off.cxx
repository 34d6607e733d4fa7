// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/off.h"

#include "filters/base/error.h"
#include "filters/geometry/polygon.h"
#include "readers/color_channels.h"
#include "readers/coordinate_check.h"
#include "readers/point_attributes.h"
#include "readers/text_scanner.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace scan
{
namespace
{

constexpr std::ptrdiff_t kStepBytes = std::ptrdiff_t(1) << 21;
constexpr std::uint64_t kShortestVertex = 6; // "0 0 0\n"
constexpr std::uint64_t kShortestFace = 2;   // "0\n"

/// What the keyword announces.
struct Keyword
{
  std::size_t length = 0;  // 0 when there is none
  bool hasTexture = false; // two numbers at the end of a line
  bool hasColors = false;
  bool hasNormals = false;
  bool isFlat = true; // three coordinates a vertex
};

/// [ST][C][N][4][n]OFF, the letters in any order; counts may follow without a blank. In small
/// letters "n" would be ambiguous, and only OFF and COFF are found.
Keyword findKeyword(std::string_view text)
{
  const bool isSmall = text.starts_with("off") || text.starts_with("coff");
  const std::size_t start = text.find(isSmall ? "off" : "OFF");
  constexpr std::size_t kLongest = 6;
  Keyword keyword;
  if (start > kLongest)
  {
    return keyword;
  }
  std::string_view letters = text.substr(0, start);
  while (!letters.empty())
  {
    const bool isTexture = letters.starts_with("ST");
    const char letter = letters.front();
    keyword.hasTexture = keyword.hasTexture || isTexture;
    keyword.hasColors = keyword.hasColors || letter == 'C' || letter == 'c';
    keyword.hasNormals = keyword.hasNormals || letter == 'N';
    keyword.isFlat = keyword.isFlat && letter != '4' && letter != 'n';
    if (!isTexture && std::string_view("CcN4n").find(letter) == std::string_view::npos)
    {
      return {};
    }
    letters.remove_prefix(isTexture ? 2 : 1);
  }
  const std::string_view rest = text.substr(start + 3);
  keyword.length = rest.empty() || isDigit(rest[0]) ? start + 3 : 0;
  return keyword;
}

/// The next character that is neither space nor in a comment.
const char* skipComments(const char* at, const char* end)
{
  at = skipSpace(at, end);
  while (at != end && *at == '#')
  {
    at = skipSpace(nextLine(at, end), end);
  }
  return at;
}

/// Reads the lines of an OFF file into a model.
class OffReader
{
public:
  OffReader(const Source& source, Execution& execution)
    : Text(source)
    , Run(execution)
    , At(skipByteOrderMark(source))
    , Reported(source.begin())
  {
  }

  Model read()
  {
    this->readKeyword();
    this->readCounts();
    for (std::uint64_t i = 0; i < this->Vertices; ++i)
    {
      this->startLine("vertices", this->Vertices, i);
      this->readVertex();
      this->endLine();
    }
    for (std::uint64_t i = 0; i < this->Faces; ++i)
    {
      this->startLine("faces", this->Faces, i);
      this->readFace();
      this->endLine();
    }
    this->finish();
    return std::move(this->Result);
  }

private:
  void readKeyword()
  {
    const char* const end = this->Text.end();
    this->At = skipComments(this->At, end);
    this->Format = findKeyword(word(this->At, end));
    if (this->Format.length == 0 && this->At != end && isDigit(*this->At))
    {
      return; // plain OFF may do without
    }
    if (this->Format.length == 0)
    {
      this->fail("expected OFF, COFF, NOFF or another keyword of an OFF file, found " +
        quoted(word(this->At, end)));
    }
    if (!this->Format.isFlat)
    {
      this->fail("this OFF file has more than three dimensions; export it as plain OFF");
    }
    this->At += this->Format.length;
    const char* const next = skipBlanks(this->At, end);
    if (word(next, end) == "BINARY")
    {
      this->fail("this OFF file is binary, which is not read; export it as text");
    }
  }

  void readCounts()
  {
    const char* const end = this->Text.end();
    this->At = skipComments(this->At, end);
    this->Vertices = this->integer("the number of vertices");
    this->At = skipBlanks(this->At, end);
    this->Faces = this->integer("the number of faces");
    const auto left = static_cast<std::uint64_t>(end - this->At);
    if (this->Vertices > left / kShortestVertex || this->Faces > left / kShortestFace)
    {
      this->fail("the counts announce " + std::to_string(this->Vertices) + " vertices and " +
        std::to_string(this->Faces) +
        " faces, more than the file can hold; it is truncated or the counts are wrong");
    }
    this->Text.checkPointCount(this->Vertices);
    if (this->Vertices == 0)
    {
      this->fail("the counts announce no vertex; there is nothing to load");
    }
    this->endLine();
    this->Result.points.reserve(this->Vertices);
    this->Result.triangles.reserve(this->Faces);
    this->Result.normals.reserve(this->Format.hasNormals ? this->Vertices : 0);
    this->Colors.reserve(this->Format.hasColors ? this->Vertices : 0);
  }

  /// Moves to the next line that holds something.
  void startLine(const char* what, std::uint64_t total, std::uint64_t done)
  {
    this->At = skipComments(this->At, this->Text.end());
    if (this->At == this->Text.end())
    {
      this->fail("the file ends after " + std::to_string(done) + " of " + std::to_string(total) +
        " " + what + "; it is truncated or the counts are wrong");
    }
    if (this->At >= this->Reported)
    {
      this->Run.step(
        "read", static_cast<std::size_t>(this->At - this->Text.begin()), this->Text.bytes.size());
      this->Reported = this->At + std::min(this->Text.end() - this->At, kStepBytes);
    }
  }

  void endLine() { this->At = nextLine(this->At, this->Text.end()); }

  void readVertex()
  {
    const char* const line = this->At;
    const Vec3 point = this->numbers("three coordinates");
    this->Result.points.push_back(point);
    this->Check.see(point, line);
    const bool hasBoth = this->Format.hasNormals && this->Format.hasColors;
    if (hasBoth && this->Result.points.size() == 1)
    {
      this->findOrder();
    }
    if (this->Format.hasColors && this->AreColorsFirst)
    {
      this->readColor();
      this->skipNumbers(this->ColorNumbers - 3);
    }
    if (this->Format.hasNormals)
    {
      this->Result.normals.push_back(unitOrZero(this->numbers("a normal of three numbers")));
    }
    if (this->Format.hasColors && !this->AreColorsFirst)
    {
      this->readColor();
    }
  }

  void readColor()
  {
    const char* const start = skipBlanks(this->At, this->Text.end());
    const Vec3 color = this->numbers("a colour of three numbers");
    if (!isChannel(color.x) || !isChannel(color.y) || !isChannel(color.z))
    {
      this->At = start;
      this->fail("a colour must be of 0 to 255 or of 0 to 1");
    }
    this->Colors.add(color.x, color.y, color.z);
  }

  /// Geomview, which made the format, has normals ahead of colours; MeshLab writes them behind.
  /// The first vertex tells, by the length of its normal.
  void findOrder()
  {
    std::vector<double> values;
    const char* const end = this->Text.end();
    double value = 0.0;
    for (const char* at = skipBlanks(this->At, end);
         at != nullptr && (at = parseNumber(at, end, value)) != nullptr; at = skipBlanks(at, end))
    {
      values.push_back(value);
    }
    const std::size_t texture = this->Format.hasTexture ? 2 : 0;
    const std::size_t count = values.size() - std::min(texture, values.size());
    if (count != 6 && count != 7) // three of each, perhaps an opacity
    {
      return;
    }
    const auto isUnit = [&](std::size_t i)
    { return std::abs(std::hypot(values[i], values[i + 1], values[i + 2]) - 1.0) < 1e-3; };
    this->AreColorsFirst = !isUnit(0) && isUnit(count - 3);
    this->ColorNumbers = count - 3;
  }

  void skipNumbers(std::size_t count)
  {
    for (; count > 0; --count)
    {
      this->At = skipBlanks(this->At, this->Text.end());
      this->At += word(this->At, this->Text.end()).size();
    }
  }

  void readFace()
  {
    const char* const end = this->Text.end();
    const std::uint64_t count = this->integer("the number of corners of a face");
    this->Face.clear();
    for (std::uint64_t i = 0; i < count; ++i)
    {
      this->At = skipBlanks(this->At, end);
      const char* const start = this->At;
      const std::uint64_t corner = this->integer("a corner of a face on its line");
      if (corner >= this->Vertices)
      {
        this->At = start;
        this->fail("a face refers to vertex " + std::to_string(corner) + ", but there are " +
          std::to_string(this->Vertices) + ", counted from 0");
      }
      this->Face.push_back(static_cast<Index>(corner));
    }
    appendPolygon(this->Result.triangles, this->Result.points, this->Face);
  }

  /// The three numbers that come next on the line.
  Vec3 numbers(const char* what)
  {
    const char* const end = this->Text.end();
    std::array<double, 3> values = {};
    for (double& value : values)
    {
      this->At = skipBlanks(this->At, end);
      const char* const stop = parseNumber(this->At, end, value);
      if (stop == nullptr || !this->isWordEnd(stop))
      {
        this->failAtWord(what);
      }
      this->At = stop;
    }
    return { values[0], values[1], values[2] };
  }

  std::uint64_t integer(const char* what)
  {
    const char* const end = this->Text.end();
    std::uint64_t value = 0;
    const char* const stop = readDigits(this->At, end, value);
    constexpr std::ptrdiff_t kSafeDigits = std::numeric_limits<std::uint64_t>::digits10;
    if (stop == this->At || stop - this->At > kSafeDigits || !this->isWordEnd(stop))
    {
      this->failAtWord(what);
    }
    this->At = stop;
    return value;
  }

  bool isWordEnd(const char* at) const
  {
    return at == this->Text.end() || isBlank(*at) || isLineEnd(*at) || *at == '#';
  }

  [[noreturn]] void failAtWord(const char* what) const
  {
    this->fail(
      "expected " + std::string(what) + ", found " + quoted(word(this->At, this->Text.end())));
  }

  [[noreturn]] void fail(const std::string& what) const { this->Text.failAtLine(this->At, what); }

  void finish()
  {
    this->At = skipComments(this->At, this->Text.end());
    if (this->At != this->Text.end())
    {
      this->fail("text follows the " + std::to_string(this->Vertices) + " vertices and " +
        std::to_string(this->Faces) + " faces that the counts announce; correct the counts");
    }
    this->Result.colors = this->Colors.take(this->Result.points.size());
    this->Check.finish(this->Text, this->Result, CoordinateCheck::Place::line);
  }

  const Source& Text;
  Execution& Run;
  const char* At;
  const char* Reported;
  Keyword Format;
  std::uint64_t Vertices = 0;
  std::uint64_t Faces = 0;
  Model Result;
  std::vector<Index> Face; // the corners of the last one
  ColorChannels Colors;
  bool AreColorsFirst = false;  // ahead of the normal
  std::size_t ColorNumbers = 3; // then
  CoordinateCheck Check;
};

} // namespace

Model parseOff(std::span<const char> bytes, std::string_view name, Execution& execution)
{
  const Source source = textOf(name, bytes);
  return OffReader(source, execution).read();
}

bool looksLikeOff(std::span<const char> head)
{
  const char* const end = head.data() + head.size();
  const char* const at = skipComments(skipUtf8Mark(head), end);
  return findKeyword(word(at, end)).length > 0;
}

} // namespace scan
