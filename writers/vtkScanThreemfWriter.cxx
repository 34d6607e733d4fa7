// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/vtkScanThreemfWriter.h"

#include "writers/threemf.h"
#include "writers/unit_note.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkScanThreemfWriter);

void vtkScanThreemfWriter::Format(
  const scan::Model& model, scan::OutputFile& file, scan::Execution& execution) const
{
  scan::writeThreemf(model, file, execution);
}

std::string vtkScanThreemfWriter::NoteOn(const scan::Model& model) const
{
  return scan::noteOnUnit(model);
}
