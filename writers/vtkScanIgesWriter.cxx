// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/vtkScanIgesWriter.h"

#include "filters/base/note.h"
#include "writers/unit_note.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkScanIgesWriter);

scan::FormatTraits vtkScanIgesWriter::Traits(const scan::Model& model) const
{
  return this->Entities == scan::IgesEntities::points
    ? scan::FormatTraits{ .hasTriangles = false }
    : scan::FormatTraits{ .hasLoosePoints = false, .leastHeight = scan::igesResolution(model) };
}

void vtkScanIgesWriter::Format(const scan::Model& model, const scan::FormatTraits&,
  scan::OutputFile& file, scan::Execution& execution) const
{
  scan::writeIges(model, { .entities = this->Entities }, file, execution);
}

std::string vtkScanIgesWriter::NoteOn(const scan::Model& model) const
{
  constexpr std::size_t kMany = 50000;
  const std::size_t triangles = model.triangles.size();
  std::string note = scan::noteOnUnit(model);
  const auto add = [&](const std::string& text) { scan::addToNote(note, text); };
  if (this->Entities == scan::IgesEntities::points)
  {
    if (!model.isScan())
    {
      add("points alone are written, as asked, no triangles and curves");
    }
  }
  else if (triangles > kMany)
  {
    add(std::to_string(triangles) +
      " triangles are as many surfaces to a CAD program, and most struggle above 50000");
  }
  return note;
}
