// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/vtkScanLasReader.h"

#include "readers/las.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkScanLasReader);

scan::Model vtkScanLasReader::Parse(
  std::span<const char> bytes, std::string_view name, scan::Execution& execution) const
{
  return scan::parseLas(bytes, name, execution);
}
