// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/vtkScanInventorWriter.h"

#include "writers/inventor.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkScanInventorWriter);

void vtkScanInventorWriter::Format(
  const scan::Model& model, scan::OutputFile& file, scan::Execution& execution) const
{
  scan::writeInventor(model, {}, file, execution);
}
