// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/vtkScanOffReader.h"

#include "readers/off.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkScanOffReader);

scan::Model vtkScanOffReader::Parse(
  std::span<const char> bytes, std::string_view name, scan::Execution& execution) const
{
  return scan::parseOff(bytes, name, execution);
}
