// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/vtkScanGltfReader.h"

#include "readers/gltf.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkScanGltfReader);

scan::Model vtkScanGltfReader::Parse(
  std::span<const char> bytes, std::string_view name, scan::Execution& execution) const
{
  return scan::parseGltf(bytes, name, execution);
}
