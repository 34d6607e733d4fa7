// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/glb.h"

#include "filters/base/error.h"
#include "filters/geometry/bounding_box.h"
#include "filters/geometry/srgb.h"
#include "writers/requirements.h"
#include "writers/single_precision.h"
#include "writers/size_limit.h"
#include "writers/write_progress.h"

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
using Rgba = std::array<std::uint16_t, 4>;

constexpr std::uint16_t kOpaque = 65535; // and full light
constexpr std::size_t kHeaderSize = 12;
constexpr std::size_t kChunkHeaderSize = 8;

/// Numbers of the glTF specification.
enum GlTf : int
{
  kUnsignedShort = 5123,
  kUnsignedInt = 5125,
  kFloat = 5126,
  kVertexBuffer = 34962,
  kIndexBuffer = 34963,
  kPoints = 0,
  kLines = 1,
  kLineLoop = 2,
  kLineStrip = 3,
  kTriangles = 4
};

double largest(const Vec3& v)
{
  return std::max({ std::abs(v.x), std::abs(v.y), std::abs(v.z) });
}

/// The normals of the model with length 1, which glTF demands: that of the surface, or any, where
/// there is none.
std::vector<Vec3> unitNormals(const Model& model)
{
  const auto isNone = [](const Vec3& normal) { return dot(normal, normal) == 0.0; };
  std::vector<Vec3> normals = model.normals;
  std::vector<Vec3> sides;
  if (std::ranges::any_of(normals, isNone))
  {
    sides.resize(normals.size());
    for (const auto& [a, b, c] : model.triangles)
    {
      const Vec3 side = cross(model.points[b] - model.points[a], model.points[c] - model.points[a]);
      for (const Index corner : { a, b, c })
      {
        sides[corner] = sides[corner] + side;
      }
    }
  }
  for (std::size_t i = 0; i < normals.size(); ++i)
  {
    const Vec3& found = isNone(normals[i]) ? sides[i] : normals[i];
    const double length = std::sqrt(dot(found, found));
    normals[i] = std::isnormal(length) ? found * (1.0 / length) : Vec3{ 0.0, 0.0, 1.0 };
  }
  return normals;
}

/// Writes one model.
class GlbWriter
{
public:
  GlbWriter(const Model& model, const Vec3& origin, OutputFile& file, Execution& execution)
    : Source(model)
    , File(file)
    , Progress(execution,
        model.points.size() + model.normals.size() + model.colors.size() + model.triangles.size() +
          model.curves.corners.size())
    , Box(model.points)
    , Origin(origin)
  {
  }

  void write()
  {
    requirePoints(this->Source, this->File);
    this->checkRange();
    const std::string json = this->describe();
    const std::uint32_t size =
      fourBytes(kHeaderSize + kChunkHeaderSize + json.size() + kChunkHeaderSize + this->Size,
        this->File.name() + ": more than 4 GiB, the limit of GLB");
    this->File.write("glTF");
    this->put(std::array<std::uint32_t, 2>{ 2, size });
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
    json["accessors"][0]["min"] = asFloats(this->Box.low - this->Origin);
    json["accessors"][0]["max"] = asFloats(this->Box.high - this->Origin);
    if (!this->Source.normals.empty())
    {
      attributes["NORMAL"] = this->addAttribute(json, sizeof(FloatVec), "VEC3", kFloat);
    }
    if (!this->Source.colors.empty())
    {
      const std::size_t colors = this->addAttribute(json, sizeof(Rgba), "VEC4", kUnsignedShort);
      json["accessors"][colors]["normalized"] = true;
      attributes["COLOR_0"] = colors;
    }
    return attributes;
  }

  bool hasManyCurves() const { return this->Source.curves.size() > kMostGlbCurves; }

  std::size_t segmentCount() const
  {
    const Polylines& curves = this->Source.curves;
    std::size_t count = 0;
    for (std::size_t i = 0; i < curves.size(); ++i)
    {
      count += curves[i].size() - std::min<std::size_t>(curves[i].size(), 1);
    }
    return count;
  }

  /// A strip or a loop for each curve.
  std::vector<Json> eachCurve(Json& json)
  {
    const Polylines& curves = this->Source.curves;
    if (curves.empty())
    {
      return {};
    }
    const std::size_t view =
      this->addView(json, curves.corners.size() * sizeof(Index), kIndexBuffer);
    std::vector<Json> primitives;
    std::size_t begin = 0;
    for (std::size_t i = 0; i < curves.size(); ++i)
    {
      const bool isLoop = isClosed(curves[i]) && curves[i].size() > 3; // a loop does not repeat
      const std::size_t accessor =
        addAccessor(json, view, curves[i].size() - (isLoop ? 1 : 0), "SCALAR", kUnsignedInt);
      json["accessors"][accessor]["byteOffset"] = begin * sizeof(Index);
      primitives.push_back(
        { { "mode", isLoop ? kLineLoop : kLineStrip }, { "indices", accessor } });
      begin += curves[i].size();
    }
    return primitives;
  }

  /// All segments of all curves in one: a primitive each would be megabytes of JSON.
  std::vector<Json> allSegments(Json& json)
  {
    const std::size_t ends = 2 * this->segmentCount();
    const std::size_t view = this->addView(json, ends * sizeof(Index), kIndexBuffer);
    return { { { "mode", kLines },
      { "indices", addAccessor(json, view, ends, "SCALAR", kUnsignedInt) } } };
  }

  /// The points of a scan, or the triangles and the curves.
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
        { "indices", addAccessor(json, view, corners, "SCALAR", kUnsignedInt) },
        { "material", 0 } });
      // the default looks like dark metal, and is not there from behind
      json["materials"] = {
        { { "pbrMetallicRoughness", { { "metallicFactor", 0.0 }, { "roughnessFactor", 0.8 } } },
          { "doubleSided", true } }
      };
    }
    const std::vector<Json> curves =
      this->hasManyCurves() ? this->allSegments(json) : this->eachCurve(json);
    for (Json primitive : curves)
    {
      primitive["attributes"] = attributes;
      primitives.push_back(std::move(primitive));
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

  template <class Values, class Stored>
  void putAll(const Values& values, const Stored& stored)
  {
    for (const auto& value : values)
    {
      this->Progress.next();
      this->put(stored(value));
    }
  }

  void writeBuffer()
  {
    const Model& model = this->Source;
    const auto asItIs = [](const auto& value) { return value; };
    this->putAll(
      model.points, [this](const Vec3& point) { return asFloats(point - this->Origin); });
    this->putAll(unitNormals(model), asFloats);
    this->putAll(model.colors,
      [](const Color& color)
      {
        const auto light = [&](std::size_t i)
        { return static_cast<std::uint16_t>(std::lround(linearOf(color[i]) * kOpaque)); };
        return Rgba{ light(0), light(1), light(2), kOpaque };
      });
    this->putAll(model.triangles, asItIs);
    if (this->hasManyCurves())
    {
      this->putSegments();
    }
    else
    {
      this->putAll(model.curves.corners, asItIs);
    }
  }

  void putSegments()
  {
    const Polylines& curves = this->Source.curves;
    for (std::size_t i = 0; i < curves.size(); ++i)
    {
      for (std::size_t k = 1; k < curves[i].size(); ++k)
      {
        this->Progress.next();
        this->put(std::array{ curves[i][k - 1], curves[i][k] });
      }
    }
  }

  const Model& Source;
  OutputFile& File;
  WriteProgress Progress;
  BoundingBox Box;
  Vec3 Origin;
  std::size_t Size = 0; // of the buffer; every part is a multiple of four bytes
};

} // namespace

void writeGlb(const Model& model, const Vec3& origin, OutputFile& file, Execution& execution)
{
  GlbWriter(model, origin, file, execution).write();
}

} // namespace scan
