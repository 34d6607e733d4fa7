// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/vtkScanPtsReader.h"

#include "readers/pts.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkScanPtsReader);

scan::Model vtkScanPtsReader::Parse(
  std::span<const char> bytes, std::string_view name, scan::Execution& execution) const
{
  return scan::parsePts(bytes, name, execution);
}
