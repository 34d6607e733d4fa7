// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/off.h"

#include "filters/base/error.h"
#include "readers/coordinate_check.h"
#include "readers/point_attributes.h"
#include "readers/text_scanner.h"

#include <array>
#include <limits>
#include <string>

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
  std::size_t length = 0; // 0 when there is none
  bool hasColors = false;
  bool hasNormals = false;
  bool isFlat = true; // three coordinates a vertex
};

/// [ST][C][N][4][n]OFF; counts may follow without a blank.
Keyword findKeyword(std::string_view text)
{
  Keyword keyword;
  std::size_t at = text.starts_with("ST") ? 2 : 0;
  const auto take = [&](char letter)
  {
    const bool isThere = at < text.size() && text[at] == letter;
    at += isThere ? 1 : 0;
    return isThere;
  };
  keyword.hasColors = take('C');
  keyword.hasNormals = take('N');
  const bool isFour = take('4');
  keyword.isFlat = !take('n') && !isFour;
  const std::string_view rest = text.substr(at);
  const bool isOff = rest.starts_with("OFF") && (rest.size() == 3 || isDigit(rest[3]));
  keyword.length = isOff ? at + 3 : 0;
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
    if (this->Vertices >= kNone)
    {
      throw Error(ErrorCode::limit,
        std::string(this->Text.name) + ": more than 4294967294 points; split the file");
    }
    if (this->Vertices == 0)
    {
      this->fail("the counts announce no vertex; there is nothing to load");
    }
    this->endLine();
    this->Result.points.reserve(this->Vertices);
    this->Result.triangles.reserve(this->Faces);
    this->Result.normals.reserve(this->Format.hasNormals ? this->Vertices : 0);
    this->Channels.reserve(this->Format.hasColors ? this->Vertices : 0);
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
    if (this->Format.hasNormals)
    {
      this->Result.normals.push_back(unitOrZero(this->numbers("a normal of three numbers")));
    }
    if (this->Format.hasColors)
    {
      const char* const start = skipBlanks(this->At, this->Text.end());
      const Vec3 color = this->numbers("a colour of three numbers");
      if (!isChannel(color.x) || !isChannel(color.y) || !isChannel(color.z))
      {
        this->At = start;
        this->fail("a colour must be of 0 to 255 or of 0 to 1");
      }
      this->LargestChannel = std::max({ this->LargestChannel, color.x, color.y, color.z });
      this->Channels.push_back(
        { static_cast<float>(color.x), static_cast<float>(color.y), static_cast<float>(color.z) });
    }
  }

  void readFace()
  {
    const char* const end = this->Text.end();
    const std::uint64_t count = this->integer("the number of corners of a face");
    Triangle fan = {};
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
      fan[i == 0 ? 0 : 1] = i < 2 ? static_cast<Index>(corner) : fan[2];
      fan[2] = static_cast<Index>(corner);
      if (i >= 2)
      {
        this->Result.triangles.push_back(fan);
      }
    }
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
    this->Check.finish(this->Text, this->Result.points.size(), CoordinateCheck::Place::line);
    const float scale = this->LargestChannel > 1.0 ? 1.0F : 255.0F;
    this->Result.colors.reserve(this->Channels.size());
    for (const auto& [red, green, blue] : this->Channels)
    {
      this->Result.colors.push_back(
        { toChannel(red * scale), toChannel(green * scale), toChannel(blue * scale) });
    }
  }

  const Source& Text;
  Execution& Run;
  const char* At;
  const char* Reported;
  Keyword Format;
  std::uint64_t Vertices = 0;
  std::uint64_t Faces = 0;
  Model Result;
  std::vector<std::array<float, 3>> Channels; // of the colours, until their range is known
  double LargestChannel = 0.0;
  CoordinateCheck Check;
};

} // namespace

Model parseOff(std::span<const char> bytes, std::string_view name, Execution& execution)
{
  const Source source{ name, bytes };
  return OffReader(source, execution).read();
}

bool looksLikeOff(std::span<const char> head)
{
  const char* const end = head.data() + head.size();
  const std::string_view mark = "\xef\xbb\xbf";
  const bool isMarked = std::string_view(head.data(), head.size()).starts_with(mark);
  const char* const at = skipComments(head.data() + (isMarked ? mark.size() : 0), end);
  return findKeyword(word(at, end)).length > 0;
}

} // namespace scan
