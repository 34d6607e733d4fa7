// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/vtkScanAutodesk3dsWriter.h"

#include "writers/autodesk_3ds.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkScanAutodesk3dsWriter);

scan::FormatTraits vtkScanAutodesk3dsWriter::Traits(const scan::Model&) const
{
  return { .hasLoosePoints = false, .precision = scan::Precision::float32 };
}

void vtkScanAutodesk3dsWriter::Format(const scan::Model& model, const scan::FormatTraits&,
  scan::OutputFile& file, scan::Execution& execution) const
{
  scan::writeAutodesk3ds(model, file, execution);
}
