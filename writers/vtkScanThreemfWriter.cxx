// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/vtkScanThreemfWriter.h"

#include "writers/threemf.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkScanThreemfWriter);

void vtkScanThreemfWriter::Format(
  const scan::Model& model, scan::OutputFile& file, scan::Execution& execution) const
{
  scan::writeThreemf(model, file, execution);
}
