// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/vtkScanIgesWriter.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkScanIgesWriter);

void vtkScanIgesWriter::Format(
  const scan::Model& model, scan::OutputFile& file, scan::Execution& execution) const
{
  scan::writeIges(model, { .entities = this->Entities, .unit = this->Unit }, file, execution);
}
