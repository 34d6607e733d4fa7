// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/autodesk_3ds.h"

#include "filters/base/error.h"
#include "writers/mesh_parts.h"
#include "writers/requirements.h"
#include "writers/single_precision.h"
#include "writers/size_limit.h"
#include "writers/write_progress.h"

#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace scan
{
namespace
{

static_assert(std::endian::native == std::endian::little, "3DS is written in place");

enum class Chunk : std::uint16_t
{
  version = 0x0002,
  masterScale = 0x0100,
  editor = 0x3d3d,
  meshVersion = 0x3d3e,
  object = 0x4000,
  triangleMesh = 0x4100,
  points = 0x4110,
  faces = 0x4120,
  axes = 0x4160,
  main = 0x4d4d
};

constexpr std::uint64_t kHeader = 6; // of a chunk
constexpr std::uint64_t kNumber = 4;
constexpr std::uint64_t kCount = 2;
constexpr std::uint64_t kPoint = 12;
constexpr std::uint64_t kFace = 8;
constexpr std::uint64_t kAxes = 48;

/// An object of the file and the sizes of its chunks, with their headers.
struct Object
{
  MeshPart part;
  std::string name;

  std::uint64_t pointsSize() const { return kHeader + kCount + kPoint * this->part.pointCount; }
  std::uint64_t facesSize() const
  {
    return kHeader + kCount + kFace * (this->part.end - this->part.begin);
  }
  std::uint64_t meshSize() const
  {
    return kHeader + this->pointsSize() + kHeader + kAxes + this->facesSize();
  }
  std::uint64_t size() const { return kHeader + this->name.size() + 1 + this->meshSize(); }
};

template <class Value>
void put(OutputFile& file, const Value& value)
{
  file.write({ reinterpret_cast<const char*>(&value), sizeof(value) });
}

/// @param size of the whole chunk
void startChunk(OutputFile& file, Chunk id, std::uint64_t size)
{
  put(file, id);
  put(file, static_cast<std::uint32_t>(size));
}

template <class Value>
void writeChunk(OutputFile& file, Chunk id, const Value& value)
{
  startChunk(file, id, kHeader + sizeof(value));
  put(file, value);
}

std::vector<Object> objectsOf(const Model& model, Execution& execution)
{
  constexpr std::size_t kMost = std::numeric_limits<std::uint16_t>::max();
  std::vector<Object> objects;
  for (const MeshPart& part : splitIntoParts(model, kMost, kMost, execution))
  {
    std::string number = std::to_string(objects.size() + 1);
    number.insert(0, number.size() < 3 ? 3 - number.size() : 0, '0');
    objects.push_back({ .part = part, .name = "part" + number });
  }
  return objects;
}

void writeObject(const Model& model, const Object& object, PartNumbering& numbering,
  OutputFile& file, WriteProgress& progress)
{
  const auto& [begin, end, pointCount] = object.part;
  numbering.startPart();
  std::vector<std::array<std::uint16_t, 4>> faces;
  constexpr std::uint16_t kVisibleEdges = 7;
  for (std::size_t i = begin; i < end; ++i)
  {
    progress.next();
    std::array<std::uint16_t, 4> face = { 0, 0, 0, kVisibleEdges };
    for (std::size_t k = 0; k < 3; ++k)
    {
      face[k] = static_cast<std::uint16_t>(numbering.numberOf(model.triangles[i][k]));
    }
    faces.push_back(face);
  }
  startChunk(file, Chunk::object, object.size());
  file.write({ object.name.c_str(), object.name.size() + 1 });
  startChunk(file, Chunk::triangleMesh, object.meshSize());
  startChunk(file, Chunk::points, object.pointsSize());
  put(file, static_cast<std::uint16_t>(pointCount));
  for (const Index point : numbering.points())
  {
    put(file, asFloats(model.points[point]));
  }
  constexpr std::array<float, 12> kModelAxes = { 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0 };
  writeChunk(file, Chunk::axes, kModelAxes);
  startChunk(file, Chunk::faces, object.facesSize());
  put(file, static_cast<std::uint16_t>(faces.size()));
  file.write({ reinterpret_cast<const char*>(faces.data()), kFace * faces.size() });
}

} // namespace

void writeAutodesk3ds(const Model& model, OutputFile& file, Execution& execution)
{
  requireTriangles(model, file, "3DS");
  requireFloatRange(model, file.name(), "3DS");
  const std::vector<Object> objects = objectsOf(model, execution);
  std::uint64_t editorSize = kHeader + 2 * (kHeader + kNumber);
  for (const Object& object : objects)
  {
    editorSize += object.size();
  }
  const std::uint64_t size = kHeader + (kHeader + kNumber) + editorSize;
  fourBytes(size, file.name() + ": more than 4 GiB, the limit of 3DS");
  constexpr std::uint32_t kVersion = 3;
  constexpr float kScale = 1.0F;
  startChunk(file, Chunk::main, size);
  writeChunk(file, Chunk::version, kVersion);
  startChunk(file, Chunk::editor, editorSize);
  writeChunk(file, Chunk::meshVersion, kVersion);
  writeChunk(file, Chunk::masterScale, kScale);
  PartNumbering numbering(model);
  WriteProgress progress(execution, model.triangles.size());
  for (const Object& object : objects)
  {
    writeObject(model, object, numbering, file, progress);
  }
}

} // namespace scan
