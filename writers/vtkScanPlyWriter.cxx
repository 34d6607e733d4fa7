// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/vtkScanPlyWriter.h"

#include "writers/ply.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkScanPlyWriter);

void vtkScanPlyWriter::Format(const scan::Model& model, const scan::FormatTraits&,
  scan::OutputFile& file, scan::Execution& execution) const
{
  scan::writePly(model, { .encoding = this->Encoding }, file, execution);
}
