// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/threemf.h"

#include "filters/base/error.h"
#include "filters/base/unit.h"
#include "filters/geometry/half_edges.h"
#include "writers/requirements.h"
#include "writers/text_line.h"
#include "writers/used_points.h"
#include "writers/zip_writer.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>

namespace scan
{
namespace
{

constexpr std::size_t kPerBlock = 8192; // elements
constexpr std::size_t kLongest = 128;   // characters of an element

constexpr std::string_view kXml = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";

constexpr std::string_view kContentTypes =
  "<Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\">"
  "<Default Extension=\"rels\""
  " ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/>"
  "<Default Extension=\"model\""
  " ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/>"
  "</Types>\n";

constexpr std::string_view kRelationships =
  "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">"
  "<Relationship Target=\"/3D/3dmodel.model\" Id=\"rel0\""
  " Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/>"
  "</Relationships>\n";

/// The name of a unit, and the number of them in a unit of the model.
std::pair<std::string_view, double> unitOf(double millimetres)
{
  static constexpr std::pair<std::string_view, double> kUnits[] = { { "micron", 0.001 },
    { "millimeter", 1.0 }, { "centimeter", 10.0 }, { "inch", 25.4 }, { "foot", 304.8 },
    { "meter", 1000.0 } };
  for (const auto& [name, size] : kUnits)
  {
    if (isSameUnit(millimetres, size))
    {
      return { name, 1.0 };
    }
  }
  return { "millimeter", millimetres > 0.0 ? millimetres : 1.0 };
}

/// Adds name="value"; the text has room.
template <class Number>
void appendAttribute(std::string& text, std::string_view name, Number value)
{
  char digits[32];
  char* const end = std::to_chars(digits, digits + sizeof(digits), value).ptr;
  text.append(name).append("\"").append(&digits[0], end).append("\"");
}

void appendVertex(std::string& text, const Vec3& point)
{
  appendAttribute(text, "<vertex x=", point.x);
  appendAttribute(text, " y=", point.y);
  appendAttribute(text, " z=", point.z);
  text.append("/>\n");
}

void appendTriangle(std::string& text, const Triangle& triangle)
{
  appendAttribute(text, "<triangle v1=", triangle[0]);
  appendAttribute(text, " v2=", triangle[1]);
  appendAttribute(text, " v3=", triangle[2]);
  text.append("/>\n");
}

/// Writes the part with the model.
class ModelPart
{
public:
  ModelPart(const Model& model, const Vec3& origin, ZipWriter& zip, Execution& execution)
    : Source(model)
    , Zip(zip)
    , Run(execution)
    , Origin(origin)
    , Total(model.points.size() + model.triangles.size())
  {
    const std::size_t count = std::max<std::size_t>(std::size_t{ 4 } * execution.threads(), 4);
    this->Blocks.resize(count);
    for (ZipBlock& block : this->Blocks) // the threads must not throw
    {
      block.text.reserve(kPerBlock * kLongest);
      block.bytes.reserve(ZipBlock::bound(kPerBlock * kLongest));
    }
  }

  void write()
  {
    const auto [unit, scale] = unitOf(this->Source.millimetresPerUnit);
    this->Zip.begin("3D/3dmodel.model");
    this->append(std::string(kXml) + "<model unit=\"" + std::string(unit) +
      "\" xml:lang=\"en-US\" xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\">\n"
      "<metadata name=\"Application\">Scanwrap</metadata>\n"
      "<resources>\n<object id=\"1\" type=\"model\">\n<mesh>\n<vertices>\n");
    this->appendAll(this->Source.points.size(),
      [&](std::string& text, std::size_t i)
      { appendVertex(text, this->Source.points[i] - this->Origin); });
    this->append("</vertices>\n<triangles>\n");
    this->appendAll(this->Source.triangles.size(),
      [&](std::string& text, std::size_t i) { appendTriangle(text, this->Source.triangles[i]); });
    this->append("</triangles>\n</mesh>\n</object>\n</resources>\n<build>\n<item objectid=\"1\"" +
      this->transform(scale) + "/>\n</build>\n</model>\n");
    this->Zip.end();
  }

private:
  /// The attribute of the item; none where everything stays in its place.
  std::string transform(double scale) const
  {
    if (scale == 1.0 && this->Origin == Vec3{})
    {
      return {};
    }
    const Vec3 place = this->Origin * scale;
    std::string matrix;
    for (const double number :
      { scale, 0.0, 0.0, 0.0, scale, 0.0, 0.0, 0.0, scale, place.x, place.y, place.z })
    {
      matrix += matrix.empty() ? "" : " ";
      matrix += TextLine().number(number);
    }
    return " transform=\"" + matrix + "\"";
  }

  void append(const std::string& text)
  {
    ZipBlock& block = this->Blocks.front();
    block.text = text;
    block.deflate();
    this->Zip.append(block);
  }

  /// Appends `count` elements, in blocks of a fixed number of elements whatever the threads.
  template <class Put>
  void appendAll(std::size_t count, const Put& put)
  {
    const std::size_t batch = kPerBlock * this->Blocks.size();
    for (std::size_t start = 0; start < count; start += batch)
    {
      this->Run.step("write", this->Done, this->Total);
      const std::size_t size = std::min(batch, count - start);
      const std::size_t blocks = (size + kPerBlock - 1) / kPerBlock;
      this->Run.parallelFor(blocks, 1,
        [&](std::size_t begin, std::size_t end)
        {
          for (std::size_t b = begin; b < end; ++b)
          {
            ZipBlock& block = this->Blocks[b];
            block.text.clear();
            const std::size_t last = std::min(start + (b + 1) * kPerBlock, start + size);
            for (std::size_t i = start + b * kPerBlock; i < last; ++i)
            {
              put(block.text, i);
            }
            block.deflate();
          }
        });
      for (std::size_t b = 0; b < blocks; ++b)
      {
        this->Zip.append(this->Blocks[b]);
      }
      this->Done += size;
    }
  }

  const Model& Source;
  ZipWriter& Zip;
  Execution& Run;
  std::vector<ZipBlock> Blocks;
  Vec3 Origin; // of the coordinates in the file
  std::size_t Total;
  std::size_t Done = 0;
};

void check(const Model& model, const Vec3& origin, const OutputFile& file)
{
  requireTriangles(model, file, "3MF");
  const auto bad = std::ranges::find_if(model.triangles, isCollapsed);
  if (bad != model.triangles.end())
  {
    throw Error(ErrorCode::badInput,
      file.name() + ": triangle " + std::to_string(bad - model.triangles.begin()) +
        ", counted from 0, uses a point twice, which 3MF forbids; remove such triangles");
  }
  constexpr double kLargest = 1e9; // of lib3mf, which most programs read with
  const auto isFar = [&](const Vec3& p)
  {
    const Vec3 place = p - origin;
    return std::max({ std::abs(place.x), std::abs(place.y), std::abs(place.z) }) > kLargest;
  };
  if (std::ranges::any_of(model.points, isFar))
  {
    throw Error(ErrorCode::limit,
      file.name() + ": a coordinate exceeds 1e9, the limit of 3MF; write PLY or OBJ");
  }
}

/// The surface with these of its points alone.
Model withPoints(const std::vector<bool>& isUsed, const Model& model)
{
  Model result;
  result.millimetresPerUnit = model.millimetresPerUnit;
  result.triangles = model.triangles;
  std::vector<Index> number(isUsed.size(), kNone);
  for (std::size_t i = 0; i < isUsed.size(); ++i)
  {
    if (isUsed[i])
    {
      number[i] = static_cast<Index>(result.points.size());
      result.points.push_back(model.points[i]);
    }
  }
  for (Triangle& triangle : result.triangles)
  {
    triangle = { number[triangle[0]], number[triangle[1]], number[triangle[2]] };
  }
  return result;
}

} // namespace

void writeThreemf(const Model& model, const Vec3& origin, OutputFile& file, Execution& execution)
{
  const std::vector<bool> isUsed = usedPoints(model.triangles, {}, model.points.size());
  if (!model.triangles.empty() && std::ranges::find(isUsed, false) != isUsed.end())
  {
    writeThreemf(withPoints(isUsed, model), origin, file, execution);
    return;
  }
  check(model, origin, file);
  ZipWriter zip(file);
  zip.add("[Content_Types].xml", std::string(kXml).append(kContentTypes));
  zip.add("_rels/.rels", std::string(kXml).append(kRelationships));
  ModelPart(model, origin, zip, execution).write();
  zip.finish();
}

} // namespace scan
