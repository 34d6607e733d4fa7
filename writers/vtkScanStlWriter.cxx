// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/vtkScanStlWriter.h"

#include "writers/stl.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkScanStlWriter);

scan::FormatTraits vtkScanStlWriter::Traits(const scan::Model&) const
{
  const bool isBinary = this->Encoding == scan::Encoding::binary;
  return { .hasLoosePoints = false,
    .precision = isBinary ? scan::Precision::float32 : scan::Precision::float64 };
}

void vtkScanStlWriter::Format(const scan::Model& model, const scan::FormatTraits&,
  scan::OutputFile& file, scan::Execution& execution) const
{
  scan::writeStl(model, { .encoding = this->Encoding }, file, execution);
}
