// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/vtkScanLegacyVtkReader.h"

#include "readers/legacy_vtk.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkScanLegacyVtkReader);

scan::Model vtkScanLegacyVtkReader::Parse(
  std::span<const char> bytes, std::string_view name, scan::Execution& execution) const
{
  return scan::parseLegacyVtk(bytes, name, execution);
}
