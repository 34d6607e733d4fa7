// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "readers/vtkScanReader.h"

/// Reads the points and faces of legacy VTK files, .vtk. See readers/legacy_vtk.h.
class SCANREADERS_EXPORT vtkScanLegacyVtkReader : public vtkScanReader
{
public:
  static vtkScanLegacyVtkReader* New();
  vtkTypeMacro(vtkScanLegacyVtkReader, vtkScanReader);
  vtkScanLegacyVtkReader(const vtkScanLegacyVtkReader&) = delete;
  void operator=(const vtkScanLegacyVtkReader&) = delete;

protected:
  vtkScanLegacyVtkReader() = default;
  ~vtkScanLegacyVtkReader() override = default;

  scan::Model Parse(
    std::span<const char> bytes, std::string_view name, scan::Execution& execution) const override;
};
