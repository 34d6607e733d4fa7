// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/vtkScanDxfWriter.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkScanDxfWriter);

scan::FormatTraits vtkScanDxfWriter::Traits(const scan::Model&) const
{
  return { .hasLoosePoints = false };
}

void vtkScanDxfWriter::Format(const scan::Model& model, const scan::FormatTraits&,
  scan::OutputFile& file, scan::Execution& execution) const
{
  scan::writeDxf(model, { .faces = this->Faces }, file, execution);
}
