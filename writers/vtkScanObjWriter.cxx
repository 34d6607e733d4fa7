// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/vtkScanObjWriter.h"

#include "writers/obj.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkScanObjWriter);

void vtkScanObjWriter::Format(const scan::Model& model, const scan::FormatTraits&,
  scan::OutputFile& file, scan::Execution& execution) const
{
  scan::writeObj(model, file, execution);
}
