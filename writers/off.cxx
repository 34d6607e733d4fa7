// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/off.h"

#include "writers/color_text.h"
#include "writers/requirements.h"
#include "writers/text_line.h"
#include "writers/write_progress.h"

namespace scan
{

void writeOff(const Model& model, OutputFile& file, Execution& execution)
{
  requirePoints(model, file);
  const bool isColored = !model.colors.empty();
  WriteProgress progress(execution, model.points.size() + model.triangles.size());
  file.write(isColored ? "COFF\n" : "OFF\n");
  constexpr int kEdges = 0; // readers do not use it
  file.write(TextLine()
               .number(model.points.size())
               .number(model.triangles.size())
               .number(kEdges)
               .text("\n"));
  for (std::size_t i = 0; i < model.points.size(); ++i)
  {
    progress.next();
    const Vec3& point = model.points[i];
    TextLine line;
    line.number(point.x).number(point.y).number(point.z);
    if (isColored)
    {
      putColor(line, model.colors[i]).text(" 1.0");
    }
    file.write(line.text("\n"));
  }
  for (const auto& [a, b, c] : model.triangles)
  {
    progress.next();
    file.write(TextLine("3").number(a).number(b).number(c).text("\n"));
  }
}

} // namespace scan
