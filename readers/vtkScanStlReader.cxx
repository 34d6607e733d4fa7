// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/vtkScanStlReader.h"

#include "readers/stl.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkScanStlReader);

scan::Model vtkScanStlReader::Parse(
  std::span<const char> bytes, std::string_view name, scan::Execution& execution) const
{
  return scan::parseStl(bytes, name, execution);
}
