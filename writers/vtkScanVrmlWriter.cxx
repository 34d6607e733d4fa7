// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/vtkScanVrmlWriter.h"

#include "writers/inventor.h"
#include "writers/single_precision.h"
#include "writers/vrml97.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkScanVrmlWriter);

void vtkScanVrmlWriter::Format(
  const scan::Model& model, scan::OutputFile& file, scan::Execution& execution) const
{
  if (this->Version1)
  {
    scan::writeInventor(model, { .version = scan::InventorVersion::vrml1 }, file, execution);
  }
  else
  {
    scan::writeVrml97(model, file, execution);
  }
}

std::vector<scan::Vec3> vtkScanVrmlWriter::Stored(const std::vector<scan::Vec3>& points) const
{
  return scan::roundedToFloat(points); // every digit is written, but this is how programs read it
}

std::string vtkScanVrmlWriter::NoteOn(const scan::Model& model) const
{
  return scan::noteOnRounding(model.points);
}
