// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/vtkScanInventorWriter.h"

#include "writers/inventor.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkScanInventorWriter);

scan::FormatTraits vtkScanInventorWriter::Traits(const scan::Model&) const
{
  return { .precision = scan::Precision::float64ReadAsFloat32 };
}

void vtkScanInventorWriter::Format(const scan::Model& model, const scan::FormatTraits&,
  scan::OutputFile& file, scan::Execution& execution) const
{
  scan::writeInventor(model, {}, file, execution);
}
