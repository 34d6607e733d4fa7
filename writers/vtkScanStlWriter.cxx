// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/vtkScanStlWriter.h"

#include "writers/stl.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkScanStlWriter);

void vtkScanStlWriter::Format(
  const scan::Model& model, scan::OutputFile& file, scan::Execution& execution) const
{
  scan::writeStl(model, { .encoding = this->Encoding }, file, execution);
}
