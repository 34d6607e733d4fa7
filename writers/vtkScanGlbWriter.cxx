// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/vtkScanGlbWriter.h"

#include "writers/glb.h"
#include "writers/single_precision.h"
#include "writers/unit_note.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkScanGlbWriter);

void vtkScanGlbWriter::Format(
  const scan::Model& model, scan::OutputFile& file, scan::Execution& execution) const
{
  scan::writeGlb(model, file, execution);
}

std::vector<scan::Vec3> vtkScanGlbWriter::Stored(const std::vector<scan::Vec3>& points) const
{
  return scan::roundedToFloat(points, scan::originForFloats(points));
}

std::string vtkScanGlbWriter::NoteOn(const scan::Model& model) const
{
  return scan::noteOnUnit(model);
}
