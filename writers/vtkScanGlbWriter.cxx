// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/vtkScanGlbWriter.h"

#include "writers/glb.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkScanGlbWriter);

void vtkScanGlbWriter::Format(
  const scan::Model& model, scan::OutputFile& file, scan::Execution& execution) const
{
  scan::writeGlb(model, file, execution);
}
