// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/glb.h"

#include "filters/base/error.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

namespace scan
{
namespace
{

static_assert(std::endian::native == std::endian::little, "numbers are written in place");

using Json = nlohmann::ordered_json;
using FloatVec = std::array<float, 3>;

constexpr std::size_t kStep = 1U << 16U;
constexpr std::size_t kHeaderSize = 12;
constexpr std::size_t kChunkHeaderSize = 8;

/// Numbers of the glTF specification.
enum GlTf : int
{
  kUnsignedByte = 5121,
  kUnsignedInt = 5125,
  kFloat = 5126,
  kVertexBuffer = 34962,
  kIndexBuffer = 34963,
  kPoints = 0,
  kTriangles = 4
};

/// How coordinates are stored: relative to `origin`, between `low` and `high`.
struct Frame
{
  Vec3 origin;
  FloatVec low;
  FloatVec high;
};

FloatVec stored(const Vec3& point, const Vec3& origin)
{
  const Vec3 offset = point - origin;
  return { static_cast<float>(offset.x), static_cast<float>(offset.y),
    static_cast<float>(offset.z) };
}

bool isFloat(const Vec3& point)
{
  const auto [x, y, z] = stored(point, {});
  return x == point.x && y == point.y && z == point.z;
}

double largest(const Vec3& v)
{
  return std::max({ std::abs(v.x), std::abs(v.y), std::abs(v.z) });
}

/// Calls visit(i) for [0, n) and reports progress; `done` of `total` is in front of them.
template <class Visit>
void forEach(
  Execution& execution, std::size_t n, std::size_t& done, std::size_t total, const Visit& visit)
{
  for (std::size_t i = 0; i < n; ++i)
  {
    if (done++ % kStep == 0)
    {
      execution.step("write", done, total);
    }
    visit(i);
  }
}

/// Writes one model.
class GlbWriter
{
public:
  GlbWriter(const Model& model, OutputFile& file, Execution& execution)
    : Source(model)
    , File(file)
    , Run(execution)
    , Total(2 * model.points.size() + model.normals.size() + model.colors.size() +
        model.triangles.size())
  {
  }

  void write()
  {
    if (this->Source.points.empty())
    {
      throw Error(ErrorCode::badInput, this->File.name() + ": no points to write");
    }
    this->findFrame();
    const std::string json = this->describe();
    constexpr std::uint64_t kLargest = std::numeric_limits<std::uint32_t>::max();
    const std::uint64_t size =
      kHeaderSize + kChunkHeaderSize + json.size() + kChunkHeaderSize + this->Size;
    if (size > kLargest)
    {
      throw Error(ErrorCode::limit,
        this->File.name() + ": more than 4 GiB, the limit of GLB; decimate, or write PLY");
    }
    this->File.write("glTF");
    this->put(std::array<std::uint32_t, 2>{ 2, static_cast<std::uint32_t>(size) });
    this->put(static_cast<std::uint32_t>(json.size()));
    this->File.write("JSON");
    this->File.write(json);
    this->put(static_cast<std::uint32_t>(this->Size));
    this->File.write({ "BIN\0", 4 });
    this->writeBuffer();
  }

private:
  template <class Value>
  void put(const Value& value)
  {
    this->File.write({ reinterpret_cast<const char*>(&value), sizeof(value) });
  }

  void findFrame()
  {
    const std::vector<Vec3>& points = this->Source.points;
    bool isExact = true;
    Vec3 low = points.front();
    Vec3 high = points.front();
    forEach(this->Run, points.size(), this->Done, this->Total,
      [&](std::size_t i)
      {
        const Vec3& p = points[i];
        isExact = isExact && isFloat(p);
        low = { std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z) };
        high = { std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z) };
      });
    const bool isFar = std::max(largest(low), largest(high)) > largest(high - low);
    this->Stored.origin = !isExact && isFar ? (low + high) * 0.5 : Vec3{};
    // rounding is monotonic: the bounds of the stored numbers are the stored bounds
    const Vec3 lowOffset = low - this->Stored.origin;
    const Vec3 highOffset = high - this->Stored.origin;
    if (std::max(largest(lowOffset), largest(highOffset)) > std::numeric_limits<float>::max())
    {
      throw Error(ErrorCode::limit,
        this->File.name() +
          ": a coordinate exceeds 3.4e38, the limit of GLB; write ascii STL, PLY or OBJ");
    }
    this->Stored.low = stored(low, this->Stored.origin);
    this->Stored.high = stored(high, this->Stored.origin);
  }

  /// Adds a buffer view and the accessor to all of it.
  /// @return the index of the accessor
  std::size_t describeView(Json& json, std::size_t count, std::size_t elementSize, const char* type,
    int componentType, int target)
  {
    const std::size_t index = json["accessors"].size();
    json["bufferViews"].push_back({ { "buffer", 0 }, { "byteOffset", this->Size },
      { "byteLength", count * elementSize }, { "target", target } });
    json["accessors"].push_back({ { "bufferView", index }, { "componentType", componentType },
      { "count", count }, { "type", type } });
    this->Size += count * elementSize;
    return index;
  }

  Json node() const
  {
    const double known = this->Source.millimetresPerUnit;
    const double unit = known > 0.0 ? known : 1.0;
    const double scale = unit / 1000.0;
    Json node = { { "mesh", 0 } };
    if (const Vec3& origin = this->Stored.origin; origin != Vec3{})
    {
      // unlike with the scale, whole millimetres stay short numbers
      node["translation"] = { origin.x * unit / 1000.0, origin.y * unit / 1000.0,
        origin.z * unit / 1000.0 };
    }
    if (scale != 1.0)
    {
      node["scale"] = { scale, scale, scale };
    }
    return node;
  }

  /// The JSON chunk, padded.
  std::string describe()
  {
    Json json = { { "asset", { { "version", "2.0" }, { "generator", "Scanwrap" } } },
      { "scene", 0 }, { "scenes", { { { "nodes", { 0 } } } } }, { "nodes", { this->node() } },
      { "meshes", Json::array() }, { "accessors", Json::array() }, { "bufferViews", Json::array() },
      { "buffers", Json::array() } };
    const std::size_t count = this->Source.points.size();
    Json attributes;
    attributes["POSITION"] =
      this->describeView(json, count, sizeof(FloatVec), "VEC3", kFloat, kVertexBuffer);
    json["accessors"][0]["min"] = this->Stored.low;
    json["accessors"][0]["max"] = this->Stored.high;
    if (!this->Source.normals.empty())
    {
      attributes["NORMAL"] =
        this->describeView(json, count, sizeof(FloatVec), "VEC3", kFloat, kVertexBuffer);
    }
    if (!this->Source.colors.empty())
    {
      const std::size_t colors =
        this->describeView(json, count, 4, "VEC4", kUnsignedByte, kVertexBuffer);
      json["accessors"][colors]["normalized"] = true;
      attributes["COLOR_0"] = colors;
    }
    Json primitive = { { "attributes", attributes }, { "mode", kPoints } };
    if (const std::size_t corners = 3 * this->Source.triangles.size(); corners > 0)
    {
      primitive["mode"] = kTriangles;
      primitive["indices"] =
        this->describeView(json, corners, sizeof(Index), "SCALAR", kUnsignedInt, kIndexBuffer);
    }
    json["meshes"].push_back({ { "primitives", Json::array({ primitive }) } });
    json["buffers"].push_back({ { "byteLength", this->Size } });
    std::string text = json.dump();
    text.resize((text.size() + 3) / 4 * 4, ' ');
    return text;
  }

  void writeBuffer()
  {
    const Model& model = this->Source;
    forEach(this->Run, model.points.size(), this->Done, this->Total,
      [&](std::size_t i) { this->put(stored(model.points[i], this->Stored.origin)); });
    forEach(this->Run, model.normals.size(), this->Done, this->Total,
      [&](std::size_t i) { this->put(stored(model.normals[i], {})); });
    forEach(this->Run, model.colors.size(), this->Done, this->Total,
      [&](std::size_t i)
      {
        const auto& [red, green, blue] = model.colors[i];
        this->put(Rgba{ red, green, blue, 255 });
      });
    forEach(this->Run, model.triangles.size(), this->Done, this->Total,
      [&](std::size_t i) { this->put(model.triangles[i]); });
  }

  using Rgba = std::array<std::uint8_t, 4>;

  const Model& Source;
  OutputFile& File;
  Execution& Run;
  std::size_t Total; // of the steps; points count twice
  std::size_t Done = 0;
  std::size_t Size = 0; // of the buffer; every part is a multiple of four bytes
  Frame Stored = {};
};

} // namespace

void writeGlb(const Model& model, OutputFile& file, Execution& execution)
{
  GlbWriter(model, file, execution).write();
}

} // namespace scan
