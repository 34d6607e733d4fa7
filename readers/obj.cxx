// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/obj.h"

#include "filters/base/error.h"
#include "readers/coordinate_check.h"
#include "readers/text_scanner.h"

#include <array>
#include <charconv>
#include <string>
#include <system_error>

namespace scan
{
namespace
{

constexpr std::size_t kStepBytes = std::size_t(1) << 21U;

/// Blanks, and line ends behind a backslash.
const char* skipGap(const char* at, const char* end)
{
  for (;;)
  {
    at = skipBlanks(at, end);
    if (at == end || *at != '\\' || at + 1 == end || !isLineEnd(at[1]))
    {
      return at;
    }
    at = nextLine(at, end);
  }
}

/// The start of the next line that does not continue this one; a comment never continues.
const char* nextStatement(const char* at, const char* end)
{
  if (*at == '#')
  {
    return nextLine(at, end);
  }
  for (bool isContinued = true; isContinued;)
  {
    const char* const stop = findLineEnd(at, end);
    isContinued = stop != end && stop != at && stop[-1] == '\\';
    at = nextLine(stop, end);
  }
  return at;
}

/// Reads the lines of an OBJ file into a mesh.
class ObjReader
{
public:
  ObjReader(const Source& source, Execution& execution)
    : Text(source)
    , Run(execution)
  {
  }

  TriMesh read()
  {
    const char* const end = this->Text.end();
    const char* reported = this->Text.begin();
    for (const char* at = skipByteOrderMark(this->Text); at != end;)
    {
      if (at >= reported)
      {
        this->Run.step(
          "read", static_cast<std::size_t>(at - this->Text.begin()), this->Text.bytes.size());
        reported = at + std::min<std::ptrdiff_t>(end - at, kStepBytes);
      }
      at = skipBlanks(at, end);
      const bool hasMore = end - at >= 2;
      if (hasMore && *at == 'v' && isBlank(at[1]))
      {
        at = this->readVertex(at + 1);
      }
      else if (hasMore && *at == 'f' && (isBlank(at[1]) || isLineEnd(at[1])))
      {
        at = this->readFace(at + 1);
      }
      at = at != end && *at == '\n' ? at + 1 : this->endStatement(at);
    }
    this->finish();
    return std::move(this->Mesh);
  }

private:
  const char* endStatement(const char* at) const
  {
    return at == this->Text.end() ? at : nextStatement(at, this->Text.end());
  }

  const char* readVertex(const char* at)
  {
    const char* const end = this->Text.end();
    const char* const line = at;
    std::array<double, 3> point = {};
    for (double& coordinate : point)
    {
      at = skipGap(at, end);
      const char* const stop = parseNumber(at, end, coordinate);
      if (stop == nullptr || !isWordEnd(stop))
      {
        this->Text.failAtLine(at, "expected three coordinates, found " + quoted(word(at, end)));
      }
      at = stop;
    }
    this->Mesh.points.push_back({ point[0], point[1], point[2] });
    this->Check.see(this->Mesh.points.back(), line);
    return at;
  }

  const char* readFace(const char* at)
  {
    const char* const end = this->Text.end();
    Triangle fan = {};
    std::size_t count = 0;
    for (at = skipGap(at, end); at != end && !isLineEnd(*at) && *at != '#'; at = skipGap(at, end))
    {
      const Index corner = this->readCorner(at);
      fan[count == 0 ? 0 : 1] = count < 2 ? corner : fan[2];
      fan[2] = corner;
      if (++count >= 3)
      {
        this->Mesh.triangles.push_back(fan);
      }
    }
    if (count == 0)
    {
      this->Text.failAtLine(at - 1, "a face without corners");
    }
    return at;
  }

  /// Reads the vertex of a corner and moves `at` behind the corner.
  Index readCorner(const char*& at)
  {
    const char* const end = this->Text.end();
    std::int64_t number = 0;
    const char* const start = at;
    const std::from_chars_result result = std::from_chars(at, end, number);
    const char* stop = result.ptr;
    while (stop != end && (*stop == '/' || *stop == '-' || isDigit(*stop)))
    {
      ++stop;
    }
    if (result.ec != std::errc() || !isWordEnd(stop) || (stop != result.ptr && *result.ptr != '/'))
    {
      this->Text.failAtLine(start, "expected a corner of a face, found " + quoted(word(at, end)));
    }
    at = stop;
    const auto known = static_cast<std::int64_t>(this->Mesh.points.size());
    const std::int64_t index = number < 0 ? known + number : number - 1;
    if (number == 0 || index < 0 || index >= static_cast<std::int64_t>(kNone))
    {
      this->failAtCorner(start, number);
    }
    if (index >= known && index > this->Furthest)
    {
      this->Furthest = index;
      this->FurthestAt = start;
    }
    return static_cast<Index>(index);
  }

  bool isWordEnd(const char* at) const
  {
    return at == this->Text.end() || isBlank(*at) || isLineEnd(*at) || *at == '\\';
  }

  [[noreturn]] void failAtCorner(const char* at, std::int64_t number) const
  {
    this->Text.failAtLine(at,
      "a face refers to vertex " + std::to_string(number) + ", but there are " +
        std::to_string(this->Mesh.points.size()) + ", counted from 1");
  }

  void finish() const
  {
    const std::size_t count = this->Mesh.points.size();
    if (count >= kNone)
    {
      throw Error(ErrorCode::limit,
        std::string(this->Text.name) + ": more than 4294967294 points; split the file");
    }
    if (this->Furthest >= static_cast<std::int64_t>(count))
    {
      this->failAtCorner(this->FurthestAt, this->Furthest + 1);
    }
    if (count == 0)
    {
      this->Text.fail("no vertex found; an OBJ file has lines 'v x y z'");
    }
    this->Check.finish(this->Text, count, CoordinateCheck::Place::line);
  }

  const Source& Text;
  Execution& Run;
  TriMesh Mesh;
  CoordinateCheck Check;
  std::int64_t Furthest = -1; // the largest index ahead of its vertex
  const char* FurthestAt = nullptr;
};

} // namespace

TriMesh parseObj(std::span<const char> bytes, std::string_view name, Execution& execution)
{
  const Source source{ name, bytes };
  return ObjReader(source, execution).read();
}

bool looksLikeObj(std::span<const char> head)
{
  static constexpr std::string_view kKeywords[] = { "v", "vn", "vt", "vp", "f", "l", "o", "g", "s",
    "mtllib", "usemtl" };
  const char* const end = head.data() + head.size();
  const char* at = skipSpace(head.data(), end);
  while (at != end && *at == '#')
  {
    at = skipSpace(nextLine(at, end), end);
  }
  const std::string_view first = word(at, end);
  return std::find(std::begin(kKeywords), std::end(kKeywords), first) != std::end(kKeywords);
}

} // namespace scan
