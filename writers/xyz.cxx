// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/xyz.h"

#include "filters/base/error.h"
#include "writers/requirements.h"
#include "writers/text_line.h"
#include "writers/write_progress.h"

namespace scan
{
namespace
{

TextLine lineOf(const Vec3& v)
{
  return TextLine().number(v.x).number(v.y).number(v.z);
}

} // namespace

void writeXyz(const Model& model, OutputFile& file, Execution& execution)
{
  requirePoints(model, file);
  WriteProgress progress(execution, model.points.size());
  for (std::size_t i = 0; i < model.points.size(); ++i)
  {
    progress.next();
    TextLine line = lineOf(model.points[i]);
    if (!model.colors.empty())
    {
      const auto& [red, green, blue] = model.colors[i];
      line.number(unsigned{ red }).number(unsigned{ green }).number(unsigned{ blue });
    }
    if (!model.normals.empty())
    {
      file.write(line.text(" "));
      line = lineOf(model.normals[i]);
    }
    file.write(line.text("\n"));
  }
}

} // namespace scan
