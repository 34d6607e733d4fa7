// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/vtkScanObjReader.h"

#include "readers/obj.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkScanObjReader);

scan::Model vtkScanObjReader::Parse(
  std::span<const char> bytes, std::string_view name, scan::Execution& execution) const
{
  return scan::parseObj(bytes, name, execution);
}
