// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "readers/vtkScanReader.h"

/// Reads Cyberware range maps, as points, or with ReadAs mesh as a mesh across the grid.
/// The colours come from the file NAME.color where there is one. See readers/cyberware.h.
class SCANREADERS_EXPORT vtkScanCyberwareReader : public vtkScanReader
{
public:
  static vtkScanCyberwareReader* New();
  vtkTypeMacro(vtkScanCyberwareReader, vtkScanReader);
  vtkScanCyberwareReader(const vtkScanCyberwareReader&) = delete;
  void operator=(const vtkScanCyberwareReader&) = delete;

protected:
  vtkScanCyberwareReader() = default;
  ~vtkScanCyberwareReader() override = default;

  scan::Model Parse(
    std::span<const char> bytes, std::string_view name, scan::Execution& execution) const override;
};
