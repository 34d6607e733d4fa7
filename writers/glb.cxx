// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/glb.h"

#include "filters/base/error.h"
#include "filters/geometry/bounding_box.h"

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
  kLineLoop = 2,
  kLineStrip = 3,
  kTriangles = 4
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

/// What coordinates are stored relative to: the middle of what is far from the origin and has more
/// digits than float32.
Vec3 originOf(const std::vector<Vec3>& points, const BoundingBox& box)
{
  const bool isFar = std::max(largest(box.low), largest(box.high)) > largest(box.high - box.low);
  return isFar && !std::ranges::all_of(points, isFloat) ? (box.low + box.high) * 0.5 : Vec3{};
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
    , Box(model.points)
    , Origin(originOf(model.points, this->Box))
    , Total(model.points.size() + model.normals.size() + model.colors.size() +
        model.triangles.size() + model.curves.corners.size())
  {
  }

  void write()
  {
    if (this->Source.points.empty())
    {
      throw Error(ErrorCode::badInput, this->File.name() + ": no points to write");
    }
    this->checkRange();
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

  void checkRange() const
  {
    const double most =
      std::max(largest(this->Box.low - this->Origin), largest(this->Box.high - this->Origin));
    if (most > std::numeric_limits<float>::max())
    {
      throw Error(ErrorCode::limit,
        this->File.name() +
          ": a coordinate exceeds 3.4e38, the limit of GLB; write ascii STL, PLY or OBJ");
    }
  }

  /// @return the index of the view
  std::size_t addView(Json& json, std::size_t size, int target)
  {
    json["bufferViews"].push_back({ { "buffer", 0 }, { "byteOffset", this->Size },
      { "byteLength", size }, { "target", target } });
    this->Size += size;
    return json["bufferViews"].size() - 1;
  }

  /// @return the index of the accessor
  static std::size_t addAccessor(
    Json& json, std::size_t view, std::size_t count, const char* type, int componentType)
  {
    json["accessors"].push_back({ { "bufferView", view }, { "componentType", componentType },
      { "count", count }, { "type", type } });
    return json["accessors"].size() - 1;
  }

  /// Adds a view of an element per point and the accessor to all of it.
  /// @return the index of the accessor
  std::size_t addAttribute(Json& json, std::size_t elementSize, const char* type, int componentType)
  {
    const std::size_t count = this->Source.points.size();
    const std::size_t view = this->addView(json, count * elementSize, kVertexBuffer);
    return addAccessor(json, view, count, type, componentType);
  }

  Json attributes(Json& json)
  {
    Json attributes;
    attributes["POSITION"] = this->addAttribute(json, sizeof(FloatVec), "VEC3", kFloat);
    // rounding is monotonic: the bounds of the stored numbers are the stored bounds
    json["accessors"][0]["min"] = stored(this->Box.low, this->Origin);
    json["accessors"][0]["max"] = stored(this->Box.high, this->Origin);
    if (!this->Source.normals.empty())
    {
      attributes["NORMAL"] = this->addAttribute(json, sizeof(FloatVec), "VEC3", kFloat);
    }
    if (!this->Source.colors.empty())
    {
      const std::size_t colors = this->addAttribute(json, 4, "VEC4", kUnsignedByte);
      json["accessors"][colors]["normalized"] = true;
      attributes["COLOR_0"] = colors;
    }
    return attributes;
  }

  /// The points of a scan, or the triangles and one primitive a curve.
  Json primitives(Json& json)
  {
    const Json attributes = this->attributes(json);
    if (this->Source.isScan())
    {
      return { { { "attributes", attributes }, { "mode", kPoints } } };
    }
    Json primitives = Json::array();
    if (const std::size_t corners = 3 * this->Source.triangles.size(); corners > 0)
    {
      const std::size_t view = this->addView(json, corners * sizeof(Index), kIndexBuffer);
      primitives.push_back({ { "attributes", attributes }, { "mode", kTriangles },
        { "indices", addAccessor(json, view, corners, "SCALAR", kUnsignedInt) } });
    }
    const Polylines& curves = this->Source.curves;
    const std::size_t view =
      curves.empty() ? 0 : this->addView(json, curves.corners.size() * sizeof(Index), kIndexBuffer);
    std::size_t begin = 0;
    for (std::size_t i = 0; i < curves.size(); ++i)
    {
      const bool isLoop = isClosed(curves[i]) && curves[i].size() > 3; // a loop does not repeat
      const std::size_t accessor =
        addAccessor(json, view, curves[i].size() - (isLoop ? 1 : 0), "SCALAR", kUnsignedInt);
      json["accessors"][accessor]["byteOffset"] = begin * sizeof(Index);
      primitives.push_back({ { "attributes", attributes },
        { "mode", isLoop ? kLineLoop : kLineStrip }, { "indices", accessor } });
      begin += curves[i].size();
    }
    return primitives;
  }

  Json node() const
  {
    const double known = this->Source.millimetresPerUnit;
    const double unit = known > 0.0 ? known : 1.0;
    const double scale = unit / 1000.0;
    Json node = { { "mesh", 0 } };
    if (const Vec3& origin = this->Origin; origin != Vec3{})
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
    Json primitives = this->primitives(json);
    json["meshes"].push_back({ { "primitives", std::move(primitives) } });
    json["buffers"].push_back({ { "byteLength", this->Size } });
    std::string text = json.dump();
    text.resize((text.size() + 3) / 4 * 4, ' ');
    return text;
  }

  void writeBuffer()
  {
    const Model& model = this->Source;
    forEach(this->Run, model.points.size(), this->Done, this->Total,
      [&](std::size_t i) { this->put(stored(model.points[i], this->Origin)); });
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
    forEach(this->Run, model.curves.corners.size(), this->Done, this->Total,
      [&](std::size_t i) { this->put(model.curves.corners[i]); });
  }

  using Rgba = std::array<std::uint8_t, 4>;

  const Model& Source;
  OutputFile& File;
  Execution& Run;
  BoundingBox Box;
  Vec3 Origin;
  std::size_t Total; // of the steps
  std::size_t Done = 0;
  std::size_t Size = 0; // of the buffer; every part is a multiple of four bytes
};

} // namespace

void writeGlb(const Model& model, OutputFile& file, Execution& execution)
{
  GlbWriter(model, file, execution).write();
}

std::vector<Vec3> glbPoints(const std::vector<Vec3>& points)
{
  const Vec3 origin = originOf(points, BoundingBox(points));
  std::vector<Vec3> result(points.size());
  std::ranges::transform(points, result.begin(),
    [&](const Vec3& point)
    {
      const auto [x, y, z] = stored(point, origin);
      return Vec3{ x, y, z };
    });
  return result;
}

} // namespace scan
