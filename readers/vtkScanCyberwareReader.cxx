// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/vtkScanCyberwareReader.h"

#include "readers/cyberware.h"
#include "readers/mapped_file.h"
#include "readers/sgi_image.h"

#include <filesystem>
#include <string>

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkScanCyberwareReader);

scan::Model vtkScanCyberwareReader::Parse(
  std::span<const char> bytes, std::string_view name, scan::Execution& execution) const
{
  scan::CyberwareScan range = scan::parseCyberwareScan(
    bytes, name, { .mesh = this->GetReadAs() == Content::mesh }, execution);
  const std::string colors = std::string(this->FileName) + ".color";
  std::error_code unknown;
  if (std::filesystem::is_regular_file(colors, unknown))
  {
    const scan::MappedFile image(colors);
    scan::addCyberwareColors(range, scan::parseSgiImage(image.bytes(), image.name()));
  }
  return std::move(range.model);
}
