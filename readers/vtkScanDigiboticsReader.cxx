// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/vtkScanDigiboticsReader.h"

#include "readers/digibotics.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkScanDigiboticsReader);

scan::Model vtkScanDigiboticsReader::Parse(
  std::span<const char> bytes, std::string_view name, scan::Execution& execution) const
{
  return scan::parseDigibotics(bytes, name, execution);
}
