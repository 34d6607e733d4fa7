// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/vtkScanThreemfReader.h"

#include "readers/threemf.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkScanThreemfReader);

scan::Model vtkScanThreemfReader::Parse(
  std::span<const char> bytes, std::string_view name, scan::Execution& execution) const
{
  return scan::parseThreemf(bytes, name, execution);
}
