// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "readers/vtkScanReader.h"

/// Reads binary and ascii STL files, .stl, welded. See readers/stl.h.
class SCANREADERS_EXPORT vtkScanStlReader : public vtkScanReader
{
public:
  static vtkScanStlReader* New();
  vtkTypeMacro(vtkScanStlReader, vtkScanReader);
  vtkScanStlReader(const vtkScanStlReader&) = delete;
  void operator=(const vtkScanStlReader&) = delete;

protected:
  vtkScanStlReader() = default;
  ~vtkScanStlReader() override = default;

  scan::Model Parse(
    std::span<const char> bytes, std::string_view name, scan::Execution& execution) const override;
};
