// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/dxf.h"

#include "filters/base/error.h"
#include "filters/geometry/bounding_box.h"
#include "writers/mesh_parts.h"
#include "writers/requirements.h"
#include "writers/text_line.h"
#include "writers/write_progress.h"

#include <span>
#include <string>
#include <string_view>

namespace scan
{
namespace
{

/// Pairs of lines: the code of a group, its value. The groups 10 to 13 hold x of four points, 20 to
/// 23 y, 30 to 33 z; 70 to 79 are 16-bit numbers.
class DxfStream
{
public:
  explicit DxfStream(OutputFile& file)
    : File(file)
  {
  }

  /// @param groups whole lines
  void text(std::string_view groups) { this->File.write(groups); }

  template <class Number>
  void group(int code, Number value)
  {
    this->File.write(TextLine().number(code).text("\n"));
    this->File.write(TextLine().number(value).text("\n"));
  }

  /// @param which 0 to 3
  void point(int which, const Vec3& p)
  {
    this->group(10 + which, p.x);
    this->group(20 + which, p.y);
    this->group(30 + which, p.z);
  }

private:
  OutputFile& File;
};

void writeHeader(const Model& model, DxfStream& dxf)
{
  const BoundingBox box(model.points);
  dxf.text("999\nDXF by Scanwrap\n0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1009\n9\n$EXTMIN\n");
  dxf.point(0, box.low);
  dxf.text("9\n$EXTMAX\n");
  dxf.point(0, box.high);
  dxf.text("0\nENDSEC\n0\nSECTION\n2\nENTITIES\n");
}

void writePoints(const Model& model, DxfStream& dxf, Execution& execution)
{
  WriteProgress progress(execution, model.points.size());
  for (const Vec3& point : model.points)
  {
    progress.next();
    dxf.text("0\nPOINT\n8\n0\n");
    dxf.point(0, point);
  }
}

void writeFaces(const Model& model, DxfStream& dxf, Execution& execution)
{
  WriteProgress progress(execution, model.triangles.size());
  for (const auto& [a, b, c] : model.triangles)
  {
    progress.next();
    dxf.text("0\n3DFACE\n8\n0\n");
    dxf.point(0, model.points[a]);
    dxf.point(1, model.points[b]);
    dxf.point(2, model.points[c]);
    dxf.point(3, model.points[c]); // a triangle repeats its third corner
  }
}

void writePolyfaces(const Model& model, DxfStream& dxf, Execution& execution)
{
  constexpr std::size_t kMost = 32767; // of points and of triangles, numbers of 16 bits
  const std::vector<MeshPart> parts = splitIntoParts(model, kMost, kMost, execution);
  PartNumbering numbering(model);
  std::vector<Triangle> triangles;
  WriteProgress progress(execution, model.triangles.size());
  for (const MeshPart& part : parts)
  {
    numbering.startPart();
    triangles.clear();
    for (std::size_t i = part.begin; i < part.end; ++i)
    {
      const auto& [a, b, c] = model.triangles[i];
      // braces: in this order
      triangles.push_back({ numbering.numberOf(a), numbering.numberOf(b), numbering.numberOf(c) });
    }
    dxf.text("0\nPOLYLINE\n8\n0\n66\n1\n10\n0\n20\n0\n30\n0\n70\n64\n");
    dxf.group(71, part.pointCount);
    dxf.group(72, triangles.size());
    for (const Index point : numbering.points())
    {
      dxf.text("0\nVERTEX\n8\n0\n");
      dxf.point(0, model.points[point]);
      dxf.text("70\n192\n"); // a vertex of a polyface mesh
    }
    for (const auto& [a, b, c] : triangles)
    {
      progress.next();
      dxf.text("0\nVERTEX\n8\n0\n10\n0\n20\n0\n30\n0\n70\n128\n"); // a face of it, counted from 1
      dxf.group(71, a + 1);
      dxf.group(72, b + 1);
      dxf.group(73, c + 1);
    }
    dxf.text("0\nSEQEND\n8\n0\n");
  }
}

void writeCurves(const Model& model, DxfStream& dxf)
{
  for (std::size_t i = 0; i < model.curves.size(); ++i)
  {
    std::span<const Index> line = model.curves[i];
    dxf.text("0\nPOLYLINE\n8\n0\n66\n1\n10\n0\n20\n0\n30\n0\n");
    dxf.group(70, isClosed(line) ? 9 : 8); // in space; 1: closed, without the first point again
    line = line.first(line.size() - (isClosed(line) ? 1 : 0));
    for (const Index point : line)
    {
      dxf.text("0\nVERTEX\n8\n0\n");
      dxf.point(0, model.points[point]);
      dxf.text("70\n32\n");
    }
    dxf.text("0\nSEQEND\n8\n0\n");
  }
}

} // namespace

void writeDxf(const Model& model, const DxfOptions& options, OutputFile& file, Execution& execution)
{
  requirePoints(model, file);
  DxfStream dxf(file);
  writeHeader(model, dxf);
  if (model.isScan())
  {
    writePoints(model, dxf, execution);
  }
  else if (options.faces == DxfFaces::polyface)
  {
    writePolyfaces(model, dxf, execution);
  }
  else
  {
    writeFaces(model, dxf, execution);
  }
  writeCurves(model, dxf);
  dxf.text("0\nENDSEC\n0\nEOF\n");
}

} // namespace scan
