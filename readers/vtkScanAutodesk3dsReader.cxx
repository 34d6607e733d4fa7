// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/vtkScanAutodesk3dsReader.h"

#include "readers/autodesk_3ds.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkScanAutodesk3dsReader);

scan::Model vtkScanAutodesk3dsReader::Parse(
  std::span<const char> bytes, std::string_view name, scan::Execution& execution) const
{
  return scan::parseAutodesk3ds(bytes, name, execution);
}
