// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/vtkScanDxfWriter.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkScanDxfWriter);

void vtkScanDxfWriter::Format(
  const scan::Model& model, scan::OutputFile& file, scan::Execution& execution) const
{
  scan::writeDxf(model, { .faces = this->Faces }, file, execution);
}
