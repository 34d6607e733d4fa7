// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/vtkScanPtxReader.h"

#include "readers/ptx.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkScanPtxReader);

scan::Model vtkScanPtxReader::Parse(
  std::span<const char> bytes, std::string_view name, scan::Execution& execution) const
{
  return scan::parsePtx(bytes, name, execution);
}
