// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/vtkScanPointsReader.h"

#include "readers/points_text.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkScanPointsReader);

scan::Model vtkScanPointsReader::Parse(
  std::span<const char> bytes, std::string_view name, scan::Execution& execution) const
{
  return scan::parsePointsText(bytes, name, execution);
}
