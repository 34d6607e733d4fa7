// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/autodesk_3ds.h"

#include "filters/base/error.h"
#include "readers/coordinate_check.h"
#include "readers/little_endian.h"

#include <cstdio>
#include <string>

namespace scan
{
namespace
{

constexpr std::ptrdiff_t kHeaderSize = 6;
constexpr std::size_t kStep = 1U << 12U;

enum ChunkId : std::uint16_t
{
  kVersion = 0x0002,
  kMain = 0x4d4d,
  kEditor = 0x3d3d,
  kObject = 0x4000,
  kTrimesh = 0x4100,
  kVertices = 0x4110,
  kFaces = 0x4120,
  kKeyframer = 0xb000
};

/// A chunk and its content, which lies in the file.
struct Chunk
{
  std::uint16_t id = 0;
  const char* begin = nullptr;
  const char* end = nullptr;
};

std::string nameOf(std::uint16_t id)
{
  char text[16] = {};
  std::snprintf(text, sizeof(text), "chunk %04X", id);
  return text;
}

/// Fills a model from the chunks of a file.
class Loader
{
public:
  Loader(const Source& source, Execution& execution)
    : Input(source)
    , Run(execution)
  {
  }

  Model load()
  {
    if (this->Input.bytes.size() < kHeaderSize ||
      loadLittle<std::uint16_t>(this->Input.begin()) != kMain)
    {
      this->Input.fail("not a 3D Studio file: it does not start with the bytes 4D 4D");
    }
    const Chunk main = this->chunkAt(this->Input.begin(), this->Input.end());
    this->forEachChunk(main.begin, main.end,
      [&](const Chunk& chunk)
      {
        if (chunk.id == kEditor)
        {
          this->forEachChunk(
            chunk.begin, chunk.end, [&](const Chunk& part) { this->loadObject(part); });
        }
      });
    if (this->Result.points.empty())
    {
      this->Input.fail("no mesh with vertices found; export meshes, not only lights and cameras");
    }
    this->Check.finish(this->Input, this->Result, CoordinateCheck::Place::byte);
    return std::move(this->Result);
  }

private:
  /// The chunk at `at`, whose header lies before `end`.
  Chunk chunkAt(const char* at, const char* end) const
  {
    const auto id = loadLittle<std::uint16_t>(at);
    const auto size = loadLittle<std::uint32_t>(at + sizeof(id));
    if (size < kHeaderSize || size > end - at)
    {
      this->Input.failAtByte(at,
        nameOf(id) + " announces " + std::to_string(size) + " bytes where there are " +
          std::to_string(end - at) + "; the file is truncated or malformed");
    }
    return { id, at + kHeaderSize, at + size };
  }

  /// Calls visit(chunk) for the chunks in [at, end). Fewer bytes than a header has are padding.
  template <class Visit>
  void forEachChunk(const char* at, const char* end, const Visit& visit)
  {
    while (end - at >= kHeaderSize)
    {
      if (this->ChunkCount++ % kStep == 0)
      {
        this->Run.step(
          "read", static_cast<std::size_t>(at - this->Input.begin()), this->Input.bytes.size());
      }
      const Chunk chunk = this->chunkAt(at, end);
      visit(chunk);
      at = chunk.end;
    }
  }

  void loadObject(const Chunk& object)
  {
    if (object.id != kObject)
    {
      return;
    }
    const auto* const nameEnd = static_cast<const char*>(
      std::memchr(object.begin, 0, static_cast<std::size_t>(object.end - object.begin)));
    if (nameEnd == nullptr)
    {
      this->Input.failAtByte(object.begin, "the name of an object does not end in its chunk");
    }
    this->forEachChunk(nameEnd + 1, object.end,
      [&](const Chunk& chunk)
      {
        if (chunk.id == kTrimesh)
        {
          this->loadTrimesh(chunk);
        }
      });
  }

  void loadTrimesh(const Chunk& trimesh)
  {
    const std::size_t firstPoint = this->Result.points.size();
    const std::size_t firstTriangle = this->Result.triangles.size();
    this->Run.step("read", static_cast<std::size_t>(trimesh.begin - this->Input.begin()),
      this->Input.bytes.size());
    this->forEachChunk(trimesh.begin, trimesh.end,
      [&](const Chunk& chunk)
      {
        if (chunk.id == kVertices)
        {
          this->loadVertices(chunk);
        }
        else if (chunk.id == kFaces)
        {
          this->loadFaces(chunk, firstPoint);
        }
      });
    this->checkCorners(trimesh, firstPoint, firstTriangle);
  }

  /// The number of records at the start of a chunk, which has room for them.
  std::size_t countOf(const Chunk& chunk, std::size_t recordSize, const char* what) const
  {
    const auto size = static_cast<std::size_t>(chunk.end - chunk.begin);
    std::uint16_t count = 0;
    if (size >= sizeof(count))
    {
      count = loadLittle<std::uint16_t>(chunk.begin);
    }
    if (size < sizeof(count) + count * recordSize)
    {
      this->Input.failAtByte(chunk.begin,
        nameOf(chunk.id) + " announces " + std::to_string(count) + " " + what + ", but has " +
          std::to_string(size) + " bytes; the file is malformed");
    }
    return count;
  }

  void loadVertices(const Chunk& chunk)
  {
    constexpr std::size_t kSize = 3 * sizeof(float);
    const std::size_t count = this->countOf(chunk, kSize, "vertices");
    this->Input.checkPointCount(this->Result.points.size() + count);
    const char* at = chunk.begin + sizeof(std::uint16_t);
    for (std::size_t i = 0; i < count; ++i, at += kSize)
    {
      this->Result.points.push_back(
        { loadLittle<float>(at), loadLittle<float>(at + 4), loadLittle<float>(at + 8) });
      this->Check.see(this->Result.points.back(), at);
    }
  }

  void loadFaces(const Chunk& chunk, std::size_t firstPoint)
  {
    constexpr std::size_t kSize = 4 * sizeof(std::uint16_t); // three corners, flags
    const std::size_t count = this->countOf(chunk, kSize, "faces");
    const auto first = static_cast<Index>(firstPoint);
    const char* at = chunk.begin + sizeof(std::uint16_t);
    for (std::size_t i = 0; i < count; ++i, at += kSize)
    {
      this->Result.triangles.push_back({ first + loadLittle<std::uint16_t>(at),
        first + loadLittle<std::uint16_t>(at + 2), first + loadLittle<std::uint16_t>(at + 4) });
    }
  }

  /// Faces may stand ahead of their vertices, so this comes last.
  void checkCorners(const Chunk& trimesh, std::size_t firstPoint, std::size_t firstTriangle) const
  {
    const std::size_t known = this->Result.points.size();
    for (std::size_t i = firstTriangle; i < this->Result.triangles.size(); ++i)
    {
      const auto& [a, b, c] = this->Result.triangles[i];
      const Index largest = std::max({ a, b, c });
      if (largest >= known)
      {
        this->Input.failAtByte(trimesh.begin,
          "a face refers to vertex " + std::to_string(largest - firstPoint) +
            " of its mesh, but there are " + std::to_string(known - firstPoint) +
            ", counted from 0");
      }
    }
  }

  const Source& Input;
  Execution& Run;
  Model Result;
  CoordinateCheck Check;
  std::size_t ChunkCount = 0;
};

} // namespace

Model parseAutodesk3ds(std::span<const char> bytes, std::string_view name, Execution& execution)
{
  const Source source{ name, bytes };
  return Loader(source, execution).load();
}

bool looksLikeAutodesk3ds(std::span<const char> head)
{
  if (head.size() < kHeaderSize || loadLittle<std::uint16_t>(head.data()) != kMain)
  {
    return false;
  }
  const auto size = loadLittle<std::uint32_t>(head.data() + 2);
  if (head.size() < 2 * kHeaderSize)
  {
    return size >= kHeaderSize;
  }
  // the first chunk inside, since TIFF and plain text may start alike
  const auto id = loadLittle<std::uint16_t>(head.data() + kHeaderSize);
  const auto inner = loadLittle<std::uint32_t>(head.data() + kHeaderSize + 2);
  return (id == kVersion || id == kEditor || id == kKeyframer) && inner >= kHeaderSize &&
    inner <= size - std::min<std::uint32_t>(size, kHeaderSize);
}

} // namespace scan
