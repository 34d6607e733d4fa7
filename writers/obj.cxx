// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/obj.h"

#include "writers/color_text.h"
#include "writers/requirements.h"
#include "writers/text_line.h"
#include "writers/write_progress.h"

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace scan
{
namespace
{

TextLine lineOf(std::string_view keyword, const Vec3& v)
{
  return TextLine(keyword).number(v.x).number(v.y).number(v.z);
}

TextLine cornersOf(const Triangle& triangle, bool hasNormals)
{
  TextLine line("f");
  for (const Index corner : triangle)
  {
    const std::uint64_t number = std::uint64_t(corner) + 1; // OBJ counts from 1
    line.number(number);
    if (hasNormals)
    {
      line.text("//").digits(number);
    }
  }
  return line;
}

} // namespace

void writeObj(const Model& model, OutputFile& file, Execution& execution)
{
  requirePoints(model, file);
  WriteProgress progress(execution,
    model.points.size() + model.normals.size() + model.triangles.size() + model.curves.size());
  file.write("# OBJ by Scanwrap\n");
  for (std::size_t i = 0; i < model.points.size(); ++i)
  {
    progress.next();
    TextLine line = lineOf("v", model.points[i]);
    if (!model.colors.empty())
    {
      putColor(line, model.colors[i]);
    }
    file.write(line.text("\n"));
  }
  for (const Vec3& normal : model.normals)
  {
    progress.next();
    file.write(lineOf("vn", normal).text("\n"));
  }
  for (const Triangle& triangle : model.triangles)
  {
    progress.next();
    file.write(cornersOf(triangle, !model.normals.empty()).text("\n"));
  }
  for (std::size_t i = 0; i < model.curves.size(); ++i)
  {
    progress.next();
    file.write("l");
    for (const Index corner : model.curves[i])
    {
      file.write(TextLine(" ").digits(std::uint64_t{ corner } + 1));
    }
    file.write("\n");
  }
}

} // namespace scan
