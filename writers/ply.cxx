// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/ply.h"

#include "writers/text_line.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>

namespace scan
{
namespace
{

static_assert(std::endian::native == std::endian::little, "binary PLY is written in place");

constexpr std::size_t kStep = 1U << 15U;

bool fitsFloat(double value)
{
  return std::abs(value) <= std::numeric_limits<float>::max() &&
    static_cast<double>(static_cast<float>(value)) == value;
}

bool fitsFloat(const TriMesh& mesh)
{
  return std::all_of(mesh.points.begin(), mesh.points.end(),
    [](const Vec3& p) { return fitsFloat(p.x) && fitsFloat(p.y) && fitsFloat(p.z); });
}

std::string header(const TriMesh& mesh, const PlyOptions& options, bool isFloat)
{
  const std::string real = isFloat ? "float" : "double";
  std::string text = "ply\nformat ";
  text += options.encoding == Encoding::ascii ? "ascii" : "binary_little_endian";
  text += " 1.0\ncomment PLY by Scanwrap\nelement vertex " + std::to_string(mesh.points.size());
  for (const char* const axis : { "x", "y", "z" })
  {
    text += "\nproperty " + real + " " + axis;
  }
  if (!mesh.triangles.empty())
  {
    const bool fitsInt = mesh.points.size() <= std::numeric_limits<std::int32_t>::max();
    text += "\nelement face " + std::to_string(mesh.triangles.size()) + "\nproperty list uchar " +
      (fitsInt ? "int" : "uint") + " vertex_indices";
  }
  return text + "\nend_header\n";
}

template <class Real>
void writeRecord(const Vec3& point, OutputFile& file)
{
  const std::array<Real, 3> values = { static_cast<Real>(point.x), static_cast<Real>(point.y),
    static_cast<Real>(point.z) };
  file.write({ reinterpret_cast<const char*>(values.data()), sizeof(values) });
}

void writeRecord(const Triangle& triangle, OutputFile& file)
{
  std::array<char, 1 + sizeof(Triangle)> record = { 3 };
  std::memcpy(record.data() + 1, triangle.data(), sizeof(Triangle));
  file.write({ record.data(), record.size() });
}

} // namespace

void writePly(
  const TriMesh& mesh, const PlyOptions& options, OutputFile& file, Execution& execution)
{
  const bool isFloat = fitsFloat(mesh);
  const bool isAscii = options.encoding == Encoding::ascii;
  const std::size_t total = mesh.points.size() + mesh.triangles.size();
  std::size_t done = 0;
  const auto report = [&]
  {
    if (done++ % kStep == 0)
    {
      execution.step("write", done, total);
    }
  };
  file.write(header(mesh, options, isFloat));
  for (const Vec3& point : mesh.points)
  {
    report();
    if (isAscii)
    {
      file.write(TextLine().number(point.x).number(point.y).number(point.z).text("\n"));
    }
    else if (isFloat)
    {
      writeRecord<float>(point, file);
    }
    else
    {
      writeRecord<double>(point, file);
    }
  }
  for (const Triangle& triangle : mesh.triangles)
  {
    report();
    if (isAscii)
    {
      const auto& [a, b, c] = triangle;
      file.write(TextLine("3").number(a).number(b).number(c).text("\n"));
    }
    else
    {
      writeRecord(triangle, file);
    }
  }
}

} // namespace scan
