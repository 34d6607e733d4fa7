// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/scene_lists.h"

#include "filters/base/error.h"
#include "writers/color_text.h"
#include "writers/requirements.h"
#include "writers/single_precision.h"
#include "writers/text_line.h"

#include <cstdint>
#include <limits>

namespace scan
{

void requireSceneLimits(const Model& model, const OutputFile& file, const std::string& format)
{
  requirePoints(model, file);
  constexpr auto kMostPoints = std::size_t{ std::numeric_limits<std::int32_t>::max() } + 1;
  if (model.points.size() > kMostPoints)
  {
    throw Error(ErrorCode::limit,
      file.name() + ": more than 2147483648 points, the limit of " + format + "; decimate");
  }
  requireFloatRange(model, file.name(), format);
}

std::size_t sceneRecords(const Model& model)
{
  return model.points.size() + model.colors.size() + model.triangles.size() + model.curves.size();
}

void writePointList(const Model& model, OutputFile& file, WriteProgress& progress)
{
  file.write("[\n");
  for (const Vec3& point : model.points)
  {
    progress.next();
    file.write(TextLine().number(point.x).number(point.y).number(point.z).text(",\n"));
  }
  file.write("]");
}

void writeColorList(const Model& model, OutputFile& file, WriteProgress& progress)
{
  file.write("[\n");
  for (const Color& color : model.colors)
  {
    progress.next();
    TextLine line;
    file.write(putColor(line, color).text(",\n"));
  }
  file.write("]");
}

void writeCurveList(const Model& model, OutputFile& file, WriteProgress& progress)
{
  file.write("[\n");
  for (std::size_t i = 0; i < model.curves.size(); ++i)
  {
    progress.next();
    for (const Index corner : model.curves[i])
    {
      file.write(TextLine().digits(corner).text(", "));
    }
    file.write("-1,\n");
  }
  file.write("]");
}

void writeTriangleList(const Model& model, OutputFile& file, WriteProgress& progress)
{
  file.write("[\n");
  for (const auto& [a, b, c] : model.triangles)
  {
    progress.next();
    TextLine line;
    line.number(a).text(",").number(b).text(",").number(c).text(", -1,\n");
    file.write(line);
  }
  file.write("]");
}

} // namespace scan
