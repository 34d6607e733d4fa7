// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/vtkScanInventorWriter.h"

#include "writers/inventor.h"
#include "writers/single_precision.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkScanInventorWriter);

void vtkScanInventorWriter::Format(
  const scan::Model& model, scan::OutputFile& file, scan::Execution& execution) const
{
  scan::writeInventor(model, {}, file, execution);
}

std::vector<scan::Vec3> vtkScanInventorWriter::Stored(const std::vector<scan::Vec3>& points) const
{
  return scan::roundedToFloat(points); // every digit is written, but this is how programs read it
}

std::string vtkScanInventorWriter::NoteOn(const scan::Model& model) const
{
  return scan::noteOnRounding(model.points);
}
