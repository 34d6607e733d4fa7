// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/vtkScanVrmlWriter.h"

#include "writers/inventor.h"
#include "writers/vrml97.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkScanVrmlWriter);

scan::FormatTraits vtkScanVrmlWriter::Traits(const scan::Model&) const
{
  return { .precision = scan::Precision::float64ReadAsFloat32 };
}

void vtkScanVrmlWriter::Format(const scan::Model& model, const scan::FormatTraits&,
  scan::OutputFile& file, scan::Execution& execution) const
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
