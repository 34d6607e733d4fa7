// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/vtkScanIgesWriter.h"
#include "writers/unit_note.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkScanIgesWriter);

void vtkScanIgesWriter::Format(
  const scan::Model& model, scan::OutputFile& file, scan::Execution& execution) const
{
  scan::writeIges(model, { .entities = this->Entities }, file, execution);
}

double vtkScanIgesWriter::LeastHeight(const scan::Model& model) const
{
  return scan::igesResolution(model);
}

std::string vtkScanIgesWriter::NoteOn(const scan::Model& model) const
{
  constexpr std::size_t kMany = 50000;
  const std::string unit = scan::noteOnUnit(model);
  return model.triangles.size() <= kMany || this->Entities == scan::IgesEntities::points
    ? unit
    : unit + (unit.empty() ? "" : "; ") + std::to_string(model.triangles.size()) +
      " triangles are as many surfaces to a CAD program, and most struggle above 50000";
}
