// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/vtkScanPcdReader.h"

#include "readers/pcd.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkScanPcdReader);

scan::Model vtkScanPcdReader::Parse(
  std::span<const char> bytes, std::string_view name, scan::Execution& execution) const
{
  return scan::parsePcd(bytes, name, execution);
}
