// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/vtkScanOffWriter.h"

#include "writers/off.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkScanOffWriter);

void vtkScanOffWriter::Format(const scan::Model& model, const scan::FormatTraits&,
  scan::OutputFile& file, scan::Execution& execution) const
{
  scan::writeOff(model, file, execution);
}
