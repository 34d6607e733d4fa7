// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/ply.h"

#include "writers/requirements.h"
#include "writers/single_precision.h"
#include "writers/text_line.h"
#include "writers/write_progress.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>

namespace scan
{
namespace
{

static_assert(std::endian::native == std::endian::little, "binary PLY is written in place");

bool fitsFloat(const std::vector<Vec3>& vectors)
{
  return std::ranges::all_of(vectors, [](const Vec3& v) { return roundedToFloat(v) == v; });
}

std::string properties(const std::string& type, const std::array<const char*, 3>& names)
{
  std::string text;
  for (const char* const name : names)
  {
    text += "\nproperty " + type + " " + name;
  }
  return text;
}

std::string header(const Model& model, const PlyOptions& options, bool isFloat)
{
  const std::string real = isFloat ? "float" : "double";
  std::string text = "ply\nformat ";
  text += options.encoding == Encoding::ascii ? "ascii" : "binary_little_endian";
  text += " 1.0\ncomment PLY by Scanwrap\nelement vertex " + std::to_string(model.points.size());
  text += properties(real, { "x", "y", "z" });
  text += model.normals.empty() ? "" : properties(real, { "nx", "ny", "nz" });
  text += model.colors.empty() ? "" : properties("uchar", { "red", "green", "blue" });
  if (!model.triangles.empty())
  {
    const bool fitsInt = model.points.size() <= std::numeric_limits<std::int32_t>::max();
    text += "\nelement face " + std::to_string(model.triangles.size()) + "\nproperty list uchar " +
      (fitsInt ? "int" : "uint") + " vertex_indices";
  }
  return text + "\nend_header\n";
}

template <class Real>
void writeBinary(const Vec3& vector, OutputFile& file)
{
  const std::array<Real, 3> values = { static_cast<Real>(vector.x), static_cast<Real>(vector.y),
    static_cast<Real>(vector.z) };
  file.write({ reinterpret_cast<const char*>(values.data()), sizeof(values) });
}

template <class Real>
void writeBinary(const Model& model, std::size_t vertex, OutputFile& file)
{
  writeBinary<Real>(model.points[vertex], file);
  if (!model.normals.empty())
  {
    writeBinary<Real>(model.normals[vertex], file);
  }
  if (!model.colors.empty())
  {
    const Color& color = model.colors[vertex];
    file.write({ reinterpret_cast<const char*>(color.data()), sizeof(color) });
  }
}

void writeAscii(const Model& model, std::size_t vertex, OutputFile& file)
{
  const Vec3& point = model.points[vertex];
  TextLine line = TextLine().number(point.x).number(point.y).number(point.z);
  if (!model.normals.empty())
  {
    const Vec3& normal = model.normals[vertex];
    file.write(line.text(" "));
    line = TextLine().number(normal.x).number(normal.y).number(normal.z);
  }
  if (!model.colors.empty())
  {
    const auto& [red, green, blue] = model.colors[vertex];
    line.number(unsigned{ red }).number(unsigned{ green }).number(unsigned{ blue });
  }
  file.write(line.text("\n"));
}

void writeBinary(const Triangle& triangle, OutputFile& file)
{
  std::array<char, 1 + sizeof(Triangle)> record = { 3 };
  std::memcpy(record.data() + 1, triangle.data(), sizeof(Triangle));
  file.write({ record.data(), record.size() });
}

void writeAscii(const Triangle& triangle, OutputFile& file)
{
  const auto& [a, b, c] = triangle;
  file.write(TextLine("3").number(a).number(b).number(c).text("\n"));
}

} // namespace

void writePly(const Model& model, const PlyOptions& options, OutputFile& file, Execution& execution)
{
  requirePoints(model, file);
  const bool isFloat = fitsFloat(model.points) && fitsFloat(model.normals);
  const bool isAscii = options.encoding == Encoding::ascii;
  using WriteVertex = void (*)(const Model&, std::size_t, OutputFile&);
  const WriteVertex writeVertex = isAscii ? WriteVertex(writeAscii)
    : isFloat                             ? WriteVertex(writeBinary<float>)
                                          : WriteVertex(writeBinary<double>);
  WriteProgress progress(execution, model.points.size() + model.triangles.size());
  file.write(header(model, options, isFloat));
  for (std::size_t i = 0; i < model.points.size(); ++i)
  {
    progress.next();
    writeVertex(model, i, file);
  }
  for (const Triangle& triangle : model.triangles)
  {
    progress.next();
    isAscii ? writeAscii(triangle, file) : writeBinary(triangle, file);
  }
}

} // namespace scan
