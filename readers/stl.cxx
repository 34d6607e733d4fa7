// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/stl.h"

#include "readers/coordinate_check.h"
#include "readers/text_scanner.h"
#include "readers/vertex_welder.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>

namespace scan
{
namespace
{

static_assert(std::endian::native == std::endian::little, "binary STL is read in place");

constexpr std::size_t kHeaderBytes = 84;
constexpr std::size_t kFacetBytes = 50;
constexpr std::size_t kStepFacets = 1U << 15U;

std::uint64_t announcedFacets(std::span<const char> bytes)
{
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + kHeaderBytes - sizeof(count), sizeof(count));
  return count;
}

Vec3 readVector(const char* at)
{
  std::array<float, 3> v = {};
  std::memcpy(v.data(), at, sizeof(v));
  return { v[0], v[1], v[2] };
}

/// Whether the text at `at` is the keyword, which is in lower case, as a whole word.
bool isKeyword(const char* at, const char* end, std::string_view keyword)
{
  for (const char expected : keyword)
  {
    if (at == end || lowerCase(*at) != expected)
    {
      return false;
    }
    ++at;
  }
  return at == end || isBlank(*at) || isLineEnd(*at);
}

/// "solid" and then text: binary headers say "solid" too, but facets are full of other bytes.
bool looksLikeText(std::span<const char> bytes)
{
  const std::span<const char> head = bytes.first(std::min<std::size_t>(bytes.size(), 512));
  const char* const end = head.data() + head.size();
  return isKeyword(skipSpace(skipUtf8Mark(head), end), end, "solid") &&
    std::find(head.begin(), head.end(), '\0') == head.end();
}

/// How many facets there are. Programs that do not know it when they write the header leave 0
/// there.
std::uint64_t countFacets(const Source& source)
{
  if (source.bytes.size() < kHeaderBytes)
  {
    source.fail("the file is too short for a binary STL header and no ascii STL; it is truncated");
  }
  const std::size_t room = source.bytes.size() - kHeaderBytes;
  const std::uint64_t announced = announcedFacets(source.bytes);
  const std::uint64_t count =
    announced == 0 && room % kFacetBytes == 0 ? room / kFacetBytes : announced;
  if (count > room / kFacetBytes)
  {
    source.failAtByte(source.end(),
      "the file ends after " + std::to_string(room / kFacetBytes) + " of " + std::to_string(count) +
        " facets; it is truncated or no STL file");
  }
  return count;
}

/// Takes the corners of facets, one after the other.
class FacetSink
{
public:
  explicit FacetSink(std::size_t facets)
    : Welder(this->Mesh.points, facets / 2)
  {
    this->Mesh.triangles.reserve(facets);
  }

  void corner(const Vec3& point, const char* at)
  {
    this->Check.see(point, at);
    this->Waiting[this->Count++] = point;
    if (this->Count == this->Waiting.size())
    {
      this->weld();
    }
  }

  Model finish(const Source& source, CoordinateCheck::Place place)
  {
    this->weld();
    if (this->Mesh.triangles.empty())
    {
      source.fail("no facet found; there is nothing to load");
    }
    this->Check.finish(source, 3 * this->Mesh.triangles.size(), place);
    return std::move(this->Mesh);
  }

private:
  void weld()
  {
    Triangle triangle = {};
    std::size_t used = 0;
    this->Welder.add({ this->Waiting.data(), this->Count },
      [&](Index corner)
      {
        triangle[used++] = corner;
        if (used == 3)
        {
          this->Mesh.triangles.push_back(triangle);
          used = 0;
        }
      });
    this->Count = 0;
  }

  Model Mesh;
  VertexWelder Welder;
  CoordinateCheck Check;
  std::array<Vec3, VertexWelder::kBatch> Waiting; // whole facets
  std::size_t Count = 0;
};

Model parseBinary(const Source& source, Execution& execution)
{
  const std::uint64_t count = countFacets(source);
  FacetSink sink(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    if (i % kStepFacets == 0)
    {
      execution.step("read", i, count);
    }
    const char* const corners = source.begin() + kHeaderBytes + i * kFacetBytes + 12;
    for (std::size_t k = 0; k < 3; ++k)
    {
      sink.corner(readVector(corners + 12 * k), corners + 12 * k);
    }
  }
  return sink.finish(source, CoordinateCheck::Place::byte);
}

/// Reads the words of an ascii file; names of solids are skipped with their line.
class AsciiReader
{
public:
  AsciiReader(const Source& source, Execution& execution)
    : Text(source)
    , Run(execution)
    , Sink(source.bytes.size() / 200) // a facet takes about 250 characters
  {
  }

  Model read()
  {
    const char* const end = this->Text.end();
    std::size_t facets = 0;
    bool isComplete = false;
    const char* at = skipSpace(skipUtf8Mark(this->Text.bytes), end);
    while (at != end)
    {
      if (isKeyword(at, end, "facet"))
      {
        if (facets++ % kStepFacets == 0)
        {
          this->Run.step(
            "read", static_cast<std::size_t>(at - this->Text.begin()), this->Text.bytes.size());
        }
        at = this->readFacet(at);
      }
      else if (isKeyword(at, end, "solid") || isKeyword(at, end, "endsolid"))
      {
        isComplete = isKeyword(at, end, "endsolid");
        at = nextLine(at, end);
      }
      else
      {
        this->fail(at, "'facet' or 'endsolid'");
      }
      at = skipSpace(at, end);
    }
    Model model = this->Sink.finish(this->Text, CoordinateCheck::Place::line);
    model.addNote(isComplete ? "" : "the text ends without 'endsolid'; the file may be truncated");
    return model;
  }

private:
  const char* readFacet(const char* at)
  {
    at = this->skipWords(this->keyword(this->keyword(at, "facet"), "normal"), 3);
    at = this->keyword(this->keyword(at, "outer"), "loop");
    for (int i = 0; i < 3; ++i)
    {
      Vec3 point;
      const char* const line = at;
      at = this->vector(this->keyword(at, "vertex"), point);
      this->Sink.corner(point, line);
    }
    return this->keyword(this->keyword(at, "endloop"), "endfacet");
  }

  const char* keyword(const char* at, std::string_view expected) const
  {
    if (!isKeyword(at, this->Text.end(), expected))
    {
      this->fail(at, quoted(expected));
    }
    return skipSpace(at + expected.size(), this->Text.end());
  }

  /// The normal of a facet follows from its corners, and files have "-1.#IND" there.
  const char* skipWords(const char* at, int count) const
  {
    for (; count > 0; --count)
    {
      at += word(at, this->Text.end()).size();
      at = skipSpace(at, this->Text.end());
    }
    return at;
  }

  const char* vector(const char* at, Vec3& value) const
  {
    for (double* const coordinate : { &value.x, &value.y, &value.z })
    {
      const char* const stop = parseNumber(at, this->Text.end(), *coordinate);
      if (stop == nullptr || (stop != this->Text.end() && !isBlank(*stop) && !isLineEnd(*stop)))
      {
        this->fail(at, "a number");
      }
      at = skipSpace(stop, this->Text.end());
    }
    return at;
  }

  [[noreturn]] void fail(const char* at, const std::string& expected) const
  {
    const std::string_view found = word(at, this->Text.end());
    this->Text.failAtLine(at,
      "expected " + expected + ", found " +
        (found.empty() ? "the end of the file; it is truncated" : quoted(found)));
  }

  const Source& Text;
  Execution& Run;
  FacetSink Sink;
};

} // namespace

Model parseStl(std::span<const char> bytes, std::string_view name, Execution& execution)
{
  const Source source{ name, bytes };
  const bool isExactlyBinary = bytes.size() >= kHeaderBytes &&
    bytes.size() == kHeaderBytes + announcedFacets(bytes) * kFacetBytes;
  if (!isExactlyBinary && looksLikeText(bytes))
  {
    const Source text = textOf(name, bytes);
    return AsciiReader(text, execution).read();
  }
  return parseBinary(source, execution);
}

bool looksLikeStl(std::span<const char> head)
{
  if (looksLikeText(head))
  {
    return true;
  }
  if (head.size() < kHeaderBytes + kFacetBytes)
  {
    return false;
  }
  const std::size_t facets =
    std::min<std::uint64_t>(announcedFacets(head), (head.size() - kHeaderBytes) / kFacetBytes);
  // Chance bytes are often far too large for coordinates, and hardly ever of length 1 or 0.
  std::size_t normals = 0;
  for (std::size_t i = 0; i < facets; ++i)
  {
    const char* const facet = head.data() + kHeaderBytes + i * kFacetBytes;
    const Vec3 normal = readVector(facet);
    const double square = dot(normal, normal);
    normals += normal == Vec3{} || std::abs(square - 1.0) < 0.1 || std::isnan(square) ? 1 : 0;
    for (std::size_t k = 1; k <= 3; ++k)
    {
      const Vec3 corner = readVector(facet + 12 * k);
      if (!(dot(corner, corner) < 1e30)) // true for NaN
      {
        return false;
      }
    }
  }
  return facets > 0 && 2 * normals >= facets;
}

} // namespace scan
