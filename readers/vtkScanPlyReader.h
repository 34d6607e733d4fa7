// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "readers/vtkScanReader.h"

/// Reads Polygon File Format files, .ply. See readers/ply.h.
class SCANREADERS_EXPORT vtkScanPlyReader : public vtkScanReader
{
public:
  static vtkScanPlyReader* New();
  vtkTypeMacro(vtkScanPlyReader, vtkScanReader);
  vtkScanPlyReader(const vtkScanPlyReader&) = delete;
  void operator=(const vtkScanPlyReader&) = delete;

protected:
  vtkScanPlyReader() = default;
  ~vtkScanPlyReader() override = default;

  scan::Model Parse(
    std::span<const char> bytes, std::string_view name, scan::Execution& execution) const override;
};
