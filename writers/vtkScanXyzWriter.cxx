// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/vtkScanXyzWriter.h"

#include "writers/xyz.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkScanXyzWriter);

scan::FormatTraits vtkScanXyzWriter::Traits(const scan::Model&) const
{
  return { .hasTriangles = false };
}

void vtkScanXyzWriter::Format(const scan::Model& model, const scan::FormatTraits&,
  scan::OutputFile& file, scan::Execution& execution) const
{
  scan::writeXyz(model, file, execution);
}
