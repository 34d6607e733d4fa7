// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/vtkScanPlyReader.h"

#include "readers/ply.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkScanPlyReader);

scan::Model vtkScanPlyReader::Parse(
  std::span<const char> bytes, std::string_view name, scan::Execution& execution) const
{
  return this->GetReadAs() == Content::mesh ? scan::parsePlyRangeGrid(bytes, name, execution)
                                            : scan::parsePly(bytes, name, execution);
}
