// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/gltf.h"

#include "filters/base/error.h"
#include "filters/geometry/srgb.h"
#include "readers/coordinate_check.h"
#include "readers/gltf_document.h"
#include "readers/gltf_scene.h"
#include "readers/text_scanner.h"

#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <string>

namespace scan
{
namespace
{

using Json = GltfDocument::Json;

constexpr std::size_t kStep = 1U << 16U;

enum Mode : std::size_t
{
  kPoints = 0,
  kLines = 1,
  kLineLoop = 2,
  kLineStrip = 3,
  kTriangles = 4,
  kStrip = 5,
  kFan = 6
};

/// Vertices that primitives share.
struct VertexSet
{
  GltfAccessor positions;
  std::optional<GltfAccessor> normals;
  std::optional<GltfAccessor> colors;
};

/// Triangles or lines on them.
struct Primitive
{
  std::size_t vertices = 0; // index of the set
  std::size_t mode = kTriangles;
  std::optional<GltfAccessor> indices;

  bool isOfLines() const { return this->mode < kTriangles; }
};

struct Mesh
{
  std::vector<VertexSet> sets;
  std::vector<Primitive> primitives;
  std::size_t pointCount = 0;
  std::size_t triangleCount = 0; // at most
  std::size_t lineCorners = 0;   // at most
  bool hasNormals = false;
  bool hasColors = false;
};

/// Fills a model from the scene of a document.
class Loader
{
public:
  Loader(const Source& source, const GltfOptions& options, Execution& execution)
    : Document(source, options.readBuffer, execution)
    , Largest(options.largest)
    , Input(source)
    , Run(execution)
    , Meshes(this->Document.size("meshes"))
  {
  }

  Model load()
  {
    for (const GltfPlacement& placed : gltfScene(this->Document, this->Run))
    {
      this->place(placed);
    }
    this->reserve();
    for (const GltfPlacement& placed : this->Scene)
    {
      this->append(*this->Meshes[placed.mesh], placed.place);
    }
    this->finish();
    return std::move(this->Result);
  }

private:
  // ---- The meshes

  void place(const GltfPlacement& placed)
  {
    const Json& json = this->Document.entry("meshes", placed.mesh);
    std::optional<Mesh>& mesh = this->Meshes[placed.mesh];
    if (!mesh)
    {
      mesh = this->resolve(json, placed.mesh);
    }
    if (mesh->pointCount > 0)
    {
      this->Scene.push_back(placed);
    }
  }

  Mesh resolve(const Json& json, std::size_t index)
  {
    Mesh mesh;
    std::map<std::array<std::size_t, 3>, std::size_t> known;
    for (const Json& primitive : this->Document.array(json, "primitives"))
    {
      this->Run.step("read", 1, 2);
      const auto attributes = primitive.find("attributes");
      const std::size_t mode = this->Document.number(primitive, "mode").value_or(kTriangles);
      if (mode > kFan)
      {
        continue;
      }
      if (attributes == primitive.end() || !attributes->contains("POSITION"))
      {
        this->Input.fail(
          "a primitive of mesh " + std::to_string(index) + " has no attribute POSITION");
      }
      constexpr std::size_t kMissing = std::numeric_limits<std::size_t>::max();
      const std::array<std::size_t, 3> key = {
        this->Document.number(*attributes, "POSITION").value_or(kMissing),
        this->Document.number(*attributes, "NORMAL").value_or(kMissing),
        this->Document.number(*attributes, "COLOR_0").value_or(kMissing)
      };
      const auto [entry, isNew] = known.emplace(key, mesh.sets.size());
      if (isNew)
      {
        VertexSet& set = mesh.sets.emplace_back();
        set.positions = this->vertexData(key[0], 0, false);
        mesh.pointCount += set.positions.count;
        if (key[1] != kMissing)
        {
          set.normals = this->vertexData(key[1], set.positions.count, false);
          mesh.hasNormals = true;
        }
        if (key[2] != kMissing)
        {
          set.colors = this->vertexData(key[2], set.positions.count, true);
          set.colors->isNormalized = true;
          mesh.hasColors = true;
        }
      }
      if (mode != kPoints)
      {
        this->resolveCorners(primitive, mesh, { entry->second, mode, {} });
      }
    }
    return mesh;
  }

  GltfAccessor vertexData(std::size_t index, std::size_t count, bool hasAlpha)
  {
    const GltfAccessor accessor = this->Document.accessor(index);
    if ((count != 0 && accessor.count != count) ||
      (accessor.components != 3 && (!hasAlpha || accessor.components != 4)))
    {
      this->Input.fail("accessor " + std::to_string(index) +
        " does not hold three numbers for each vertex; the file is malformed");
    }
    return accessor;
  }

  void resolveCorners(const Json& json, Mesh& mesh, Primitive primitive)
  {
    std::size_t count = mesh.sets[primitive.vertices].positions.count;
    if (const std::optional<std::size_t> indices = this->Document.number(json, "indices"))
    {
      primitive.indices = this->Document.accessor(*indices);
      count = primitive.indices->count;
      if (primitive.indices->components != 1 || !primitive.indices->isUnsigned())
      {
        this->Input.fail("accessor " + std::to_string(*indices) + " does not hold indices");
      }
    }
    if (primitive.mode == kTriangles && count % 3 != 0)
    {
      this->Input.fail("triangles have " + std::to_string(count) +
        " corners, which is not a multiple of three; the file is malformed");
    }
    if (count < (primitive.isOfLines() ? 2U : 3U))
    {
      return;
    }
    if (primitive.isOfLines())
    {
      mesh.lineCorners += count + 1;
    }
    else
    {
      mesh.triangleCount += primitive.mode == kTriangles ? count / 3 : count - 2;
    }
    mesh.primitives.push_back(primitive);
  }

  // ---- The model

  /// A mesh may be shown many times: what all that takes is known before memory is taken.
  void reserve()
  {
    double points = 0.0;
    double triangles = 0.0;
    double lineCorners = 0.0;
    for (const GltfPlacement& placed : this->Scene)
    {
      const Mesh& mesh = *this->Meshes[placed.mesh];
      points += static_cast<double>(mesh.pointCount);
      triangles += static_cast<double>(mesh.triangleCount);
      lineCorners += static_cast<double>(mesh.lineCorners);
      this->HasNormals = this->HasNormals || mesh.hasNormals;
      this->HasColors = this->HasColors || mesh.hasColors;
    }
    const double bytes = points * (this->HasNormals ? 51.0 : 27.0) +
      (triangles + lineCorners) * double(sizeof(Triangle));
    if (bytes > std::max(this->Largest, 12.0 * static_cast<double>(this->Document.bytes())))
    {
      this->Input.fail("the scene shows its meshes so often that they take " +
        std::to_string(static_cast<std::uint64_t>(std::min(bytes, 1e18) / 1e6)) +
        " MB; export it with fewer copies");
    }
    this->Input.checkPointCount(static_cast<std::uint64_t>(points));
    const auto count = static_cast<std::size_t>(points);
    this->Result.points.reserve(count);
    this->Result.normals.reserve(this->HasNormals ? count : 0);
    this->Result.colors.reserve(this->HasColors ? count : 0);
    this->Result.triangles.reserve(static_cast<std::size_t>(triangles));
    this->Total = static_cast<std::size_t>(points + triangles + lineCorners);
  }

  void report()
  {
    if (this->Done++ % kStep == 0)
    {
      this->Run.step("read", this->Total + this->Done, 2 * this->Total);
    }
  }

  void append(const Mesh& mesh, const Affine& place)
  {
    std::vector<Index> firsts;
    for (const VertexSet& set : mesh.sets)
    {
      firsts.push_back(static_cast<Index>(this->Result.points.size()));
      for (std::size_t i = 0; i < set.positions.count; ++i)
      {
        this->report();
        this->appendVertex(set, i, place);
      }
    }
    for (const Primitive& primitive : mesh.primitives)
    {
      const std::size_t known = mesh.sets[primitive.vertices].positions.count;
      const Index first = firsts[primitive.vertices];
      if (primitive.isOfLines())
      {
        this->appendLines(primitive, known, first);
      }
      else
      {
        this->appendTriangles(primitive, known, first, place.isMirror());
      }
    }
  }

  static Vec3 vectorOf(const GltfAccessor& values, std::size_t i)
  {
    return { values.real(i, 0), values.real(i, 1), values.real(i, 2) };
  }

  void appendVertex(const VertexSet& set, std::size_t i, const Affine& place)
  {
    this->Result.points.push_back(place.point(vectorOf(set.positions, i)));
    this->Check.see(this->Result.points.back());
    if (this->HasNormals)
    {
      this->Result.normals.push_back(
        set.normals ? place.normal(vectorOf(*set.normals, i)) : Vec3{});
    }
    if (this->HasColors)
    {
      const Vec3 color = set.colors ? vectorOf(*set.colors, i) : Vec3{ 1.0, 1.0, 1.0 };
      this->Result.colors.push_back({ channelOf(color.x), channelOf(color.y), channelOf(color.z) });
    }
  }

  /// Calls visit(corner) for the corners of a primitive, as indices of the model.
  /// @param known number of vertices of its set, the first of which is `first`
  template <class Visit>
  void forEachCorner(const Primitive& primitive, std::size_t known, Index first, const Visit& visit)
  {
    const std::size_t count = primitive.indices ? primitive.indices->count : known;
    for (std::size_t i = 0; i < count; ++i)
    {
      this->report();
      const std::size_t corner = primitive.indices ? primitive.indices->integer(i) : i;
      if (corner >= known)
      {
        this->Input.fail("accessor " + std::to_string(primitive.indices->index) +
          " refers to vertex " + std::to_string(corner) + ", but there are " +
          std::to_string(known) + ", counted from 0");
      }
      visit(first + static_cast<Index>(corner));
    }
  }

  void appendLines(const Primitive& primitive, std::size_t known, Index first)
  {
    Polylines& curves = this->Result.curves;
    const std::size_t begin = curves.corners.size();
    std::size_t ends = 0; // of segments
    this->forEachCorner(primitive, known, first,
      [&](Index corner)
      {
        ++ends;
        if (primitive.mode == kLines && ends > 1 && ends % 2 == 1)
        {
          if (curves.corners.back() == corner) // goes on where the last segment ends
          {
            return;
          }
          curves.endLine();
        }
        curves.corners.push_back(corner);
      });
    if (primitive.mode == kLineLoop)
    {
      curves.corners.push_back(Index{ curves.corners[begin] });
    }
    curves.endLine();
  }

  void appendTriangles(const Primitive& primitive, std::size_t known, Index first, bool isMirrored)
  {
    Triangle last = {};
    std::size_t used = 0;
    this->forEachCorner(primitive, known, first,
      [&](Index corner)
      {
        const bool isFan = primitive.mode == kFan && used >= 3;
        last = { isFan ? last[0] : last[1], last[2], corner };
        ++used;
        if (used < 3 || (primitive.mode == kTriangles && used % 3 != 0))
        {
          return;
        }
        const bool isSwapped = (primitive.mode == kStrip && used % 2 == 0) != isMirrored;
        const auto [a, b, c] = last;
        if (primitive.mode != kStrip || (a != b && b != c && c != a)) // strips are joined so
        {
          this->Result.triangles.push_back(isSwapped ? Triangle{ b, a, c } : Triangle{ a, b, c });
        }
      });
  }

  void finish()
  {
    if (this->Result.points.empty())
    {
      this->Input.fail("the scene has no points and no triangles; export meshes");
    }
    this->Check.finish(this->Input, this->Result, CoordinateCheck::Place::unknown);
    this->Result.millimetresPerUnit = 1000.0;
  }

  GltfDocument Document;
  double Largest;
  const Source& Input;
  Execution& Run;
  std::vector<std::optional<Mesh>> Meshes;
  std::vector<GltfPlacement> Scene;
  Model Result;
  bool HasNormals = false;
  bool HasColors = false;
  CoordinateCheck Check;
  std::size_t Total = 0;
  std::size_t Done = 0;
};

} // namespace

Model parseGltf(std::span<const char> bytes, std::string_view name, Execution& execution)
{
  return parseGltfScene(bytes, name, {}, execution);
}

Model parseGltfScene(std::span<const char> bytes, std::string_view name, const GltfOptions& options,
  Execution& execution)
{
  const Source source{ name, bytes };
  try
  {
    return Loader(source, options, execution).load();
  }
  catch (const Json::exception& error)
  {
    source.fail("malformed glTF: " + quoted(error.what()));
  }
}

bool looksLikeGltf(std::span<const char> head)
{
  const std::string_view text(head.data(), head.size());
  if (text.starts_with("glTF"))
  {
    return true;
  }
  const char* const end = head.data() + head.size();
  const char* const first = skipSpace(skipUtf8Mark(head), end);
  if (first == end || *first != '{')
  {
    return false;
  }
  for (const char* const key :
    { "\"asset\"", "\"accessors\"", "\"bufferViews\"", "\"buffers\"", "\"meshes\"", "\"scenes\"" })
  {
    if (text.find(key) != std::string_view::npos)
    {
      return true;
    }
  }
  return false;
}

} // namespace scan
