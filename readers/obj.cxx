// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/obj.h"

#include "filters/base/error.h"
#include "filters/geometry/polygon.h"
#include "readers/color_channels.h"
#include "readers/coordinate_check.h"
#include "readers/point_attributes.h"
#include "readers/text_scanner.h"

#include <array>
#include <charconv>
#include <string>
#include <system_error>
#include <utility>

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

/// Reads the lines of an OBJ file into a model.
class ObjReader
{
public:
  ObjReader(const Source& source, Execution& execution)
    : Text(source)
    , Run(execution)
  {
  }

  Model read()
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
      else if (hasMore && *at == 'l' && isBlank(at[1]))
      {
        at = this->readLine(at + 1);
      }
      else if (hasMore && *at == 'v' && at[1] == 'n' && this->HasPointNormals)
      {
        at = this->readNormal(at + 2);
      }
      at = at != end && *at == '\n' ? at + 1 : this->endStatement(at);
    }
    this->finishNormals();
    this->Mesh.colors = this->Colors.take(this->Mesh.points.size());
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
    const char* const line = at;
    Vec3 point;
    const char* const stop = this->readThree(at, point);
    if (stop == nullptr)
    {
      this->Text.failAtLine(
        at, "expected three coordinates, found " + quoted(word(at, this->Text.end())));
    }
    this->Mesh.points.push_back(point);
    this->Check.see(point, line);
    return stop == this->Text.end() || isLineEnd(*stop) ? stop : this->readColor(stop);
  }

  /// The colour of the last vertex; a weight, also ahead of it, or a comment may stand there, too.
  const char* readColor(const char* at)
  {
    Vec3 color;
    const char* stop = this->readThree(at, color);
    double further = 0.0;
    const char* const next = stop != nullptr ? skipGap(stop, this->Text.end()) : nullptr;
    const char* const last =
      next != nullptr ? parseNumber(next, this->Text.end(), further) : nullptr;
    if (last != nullptr && this->isWordEnd(last))
    {
      color = { color.y, color.z, further };
      stop = last;
    }
    if (stop != nullptr)
    {
      this->Colors.skipTo(this->Mesh.points.size() - 1);
      this->Colors.add(color.x, color.y, color.z);
    }
    return stop != nullptr ? stop : at;
  }

  const char* readNormal(const char* at)
  {
    Vec3 normal;
    const char* const stop = this->readThree(at, normal);
    this->HasPointNormals = stop != nullptr;
    this->Mesh.normals.push_back(unitOrZero(normal));
    return stop != nullptr ? stop : at;
  }

  /// @param[out] start the word that is no number, when there is one
  /// @return behind the numbers, nullptr when there are not three
  const char* readThree(const char*& start, Vec3& values) const
  {
    const char* const end = this->Text.end();
    const char* at = start;
    std::array<double, 3> numbers = {};
    for (double& number : numbers)
    {
      at = skipGap(at, end);
      const char* const stop = parseNumber(at, end, number);
      if (stop == nullptr || !this->isWordEnd(stop))
      {
        start = at;
        return nullptr;
      }
      at = stop;
    }
    values = { numbers[0], numbers[1], numbers[2] };
    return at;
  }

  const char* readFace(const char* at)
  {
    const char* const end = this->Text.end();
    this->Face.clear();
    for (at = skipGap(at, end); at != end && !isLineEnd(*at) && *at != '#'; at = skipGap(at, end))
    {
      this->Face.push_back(this->readCorner(at));
    }
    if (this->Face.empty())
    {
      this->Text.failAtLine(at - 1, "a face without corners");
    }
    const bool isAhead = std::ranges::any_of(
      this->Face, [&](Index corner) { return corner >= this->Mesh.points.size(); });
    if (isAhead && this->Face.size() > 3)
    {
      std::vector<Index>& corners = this->Waiting.corners;
      corners.insert(corners.end(), this->Face.begin(), this->Face.end());
      this->Waiting.endLine();
    }
    else
    {
      appendPolygon(this->Mesh.triangles, this->Mesh.points, this->Face);
    }
    return at;
  }

  const char* readLine(const char* at)
  {
    const char* const end = this->Text.end();
    for (at = skipGap(at, end); at != end && !isLineEnd(*at) && *at != '#'; at = skipGap(at, end))
    {
      this->Mesh.curves.corners.push_back(this->readVertexNumber(at).first);
    }
    this->Mesh.curves.endLine();
    return at;
  }

  /// Reads the vertex of a corner of a face and moves `at` behind the corner.
  Index readCorner(const char*& at)
  {
    const auto [index, rest] = this->readVertexNumber(at);
    if (this->HasPointNormals)
    {
      this->HasPointNormals = this->normalOf(rest) == std::int64_t{ index };
      this->Corners = std::max(this->Corners, std::size_t{ index } + 1);
    }
    return index;
  }

  /// Reads a vertex of an element and moves `at` behind it.
  /// @return the index of the vertex, and what follows its number: "/7/3"
  std::pair<Index, std::string_view> readVertexNumber(const char*& at)
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
      this->Text.failAtLine(
        start, "expected a corner of a face or line, found " + quoted(word(at, end)));
    }
    at = stop;
    const std::string_view rest(result.ptr, static_cast<std::size_t>(stop - result.ptr));
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
    return { static_cast<Index>(index), rest };
  }

  /// The index of the normal of a corner, of which `rest` follows the vertex; -1 without one.
  std::int64_t normalOf(std::string_view rest) const
  {
    const std::size_t slash = rest.find('/', 1);
    std::int64_t number = 0;
    if (slash != rest.npos)
    {
      std::from_chars(rest.data() + slash + 1, rest.data() + rest.size(), number);
    }
    const auto known = static_cast<std::int64_t>(this->Mesh.normals.size());
    return number < 0 ? known + number : number - 1;
  }

  bool isWordEnd(const char* at) const
  {
    return at == this->Text.end() || isBlank(*at) || isLineEnd(*at) || *at == '\\';
  }

  [[noreturn]] void failAtCorner(const char* at, std::int64_t number) const
  {
    this->Text.failAtLine(at,
      "a face or line refers to vertex " + std::to_string(number) + ", but there are " +
        std::to_string(this->Mesh.points.size()) + ", counted from 1");
  }

  void finish()
  {
    const std::size_t count = this->Mesh.points.size();
    this->Text.checkPointCount(count);
    if (this->Furthest >= static_cast<std::int64_t>(count))
    {
      this->failAtCorner(this->FurthestAt, this->Furthest + 1);
    }
    if (count == 0)
    {
      this->Text.fail("no vertex found; an OBJ file has lines 'v x y z'");
    }
    appendPolygons(this->Mesh.triangles, this->Mesh.points, this->Waiting);
    this->Check.finish(this->Text, this->Mesh, CoordinateCheck::Place::line);
  }

  /// Normals are kept when they are those of the points: of each corner, or of each point of a
  /// scan.
  void finishNormals()
  {
    const std::size_t count = this->Mesh.points.size();
    const std::size_t normals = this->Mesh.normals.size();
    // corners may leave out the last vertices
    const bool isComplete = this->Corners > 0 ? normals >= this->Corners : normals == count;
    if (this->HasPointNormals && isComplete && normals > 0)
    {
      this->Mesh.normals.resize(count);
    }
    else
    {
      this->Mesh.normals = {};
    }
  }

  const Source& Text;
  Execution& Run;
  Model Mesh;
  std::vector<Index> Face; // the corners of the last one
  Polylines Waiting;       // faces ahead of their vertices
  ColorChannels Colors;
  CoordinateCheck Check;
  bool HasPointNormals = true; // as far as known, normals and vertices have the same indices
  std::size_t Corners = 0;     // vertices up to the last one of a corner
  std::int64_t Furthest = -1;  // the largest index ahead of its vertex
  const char* FurthestAt = nullptr;
};

} // namespace

Model parseObj(std::span<const char> bytes, std::string_view name, Execution& execution)
{
  const Source source = textOf(name, bytes);
  return ObjReader(source, execution).read();
}

bool looksLikeObj(std::span<const char> head)
{
  static constexpr std::string_view kKeywords[] = { "v", "vn", "vt", "vp", "f", "l", "o", "g", "s",
    "mtllib", "usemtl" };
  const char* const end = head.data() + head.size();
  const char* at = skipSpace(skipUtf8Mark(head), end);
  while (at != end && *at == '#')
  {
    at = skipSpace(nextLine(at, end), end);
  }
  const std::string_view first = word(at, end);
  return std::find(std::begin(kKeywords), std::end(kKeywords), first) != std::end(kKeywords);
}

} // namespace scan
