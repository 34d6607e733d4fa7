// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/stl.h"

#include "filters/base/error.h"
#include "writers/requirements.h"
#include "writers/single_precision.h"
#include "writers/size_limit.h"
#include "writers/text_line.h"

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

static_assert(std::endian::native == std::endian::little, "binary STL is written in place");

constexpr std::size_t kStep = 1U << 15U;

Vec3 normalOf(const Vec3& a, const Vec3& b, const Vec3& c)
{
  const Vec3 normal = cross(b - a, c - a);
  const double length = std::sqrt(dot(normal, normal));
  return length > 0.0 ? normal * (1.0 / length) : Vec3{};
}

void writeBinary(const TriMesh& mesh, OutputFile& file, Execution& execution)
{
  std::string header = "binary STL by Scanwrap";
  header.resize(80, ' ');
  const std::uint32_t count = fourBytes(
    mesh.triangles.size(), file.name() + ": 4294967295 triangles or more, the limit of binary STL");
  header.append(reinterpret_cast<const char*>(&count), sizeof(count));
  file.write(header);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
  {
    if (i % kStep == 0)
    {
      execution.step("write", i, mesh.triangles.size());
    }
    std::array<Vec3, 4> vectors = {}; // the normal and the corners
    for (std::size_t k = 0; k < 3; ++k)
    {
      vectors[k + 1] = roundedToFloat(mesh.points[mesh.triangles[i][k]]);
    }
    vectors[0] = normalOf(vectors[1], vectors[2], vectors[3]);
    std::array<char, 50> record = {}; // ends with two bytes of attributes, 0
    char* at = record.data();
    for (const Vec3& v : vectors)
    {
      const std::array<float, 3> single = asFloats(v);
      std::memcpy(at, single.data(), sizeof(single));
      at += sizeof(single);
    }
    file.write({ record.data(), record.size() });
  }
}

std::string_view put(TextLine& line, const Vec3& v)
{
  return line.number(v.x).number(v.y).number(v.z).text("\n");
}

void writeAscii(const TriMesh& mesh, OutputFile& file, Execution& execution)
{
  file.write("solid Scanwrap\n");
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
  {
    if (i % kStep == 0)
    {
      execution.step("write", i, mesh.triangles.size());
    }
    const auto& [a, b, c] = mesh.triangles[i];
    TextLine facet("facet normal");
    file.write(put(facet, normalOf(mesh.points[a], mesh.points[b], mesh.points[c])));
    file.write("outer loop\n");
    for (const Index corner : mesh.triangles[i])
    {
      TextLine vertex("vertex");
      file.write(put(vertex, mesh.points[corner]));
    }
    file.write("endloop\nendfacet\n");
  }
  file.write("endsolid Scanwrap\n");
}

} // namespace

void writeStl(
  const TriMesh& mesh, const StlOptions& options, OutputFile& file, Execution& execution)
{
  requireTriangles(mesh, file, "STL");
  if (options.encoding == Encoding::ascii)
  {
    writeAscii(mesh, file, execution);
    return;
  }
  requireFloatRange(mesh, file.name(), "binary STL");
  writeBinary(mesh, file, execution);
}

} // namespace scan
