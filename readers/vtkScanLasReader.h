// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "readers/vtkScanReader.h"

/// Reads LAS clouds. See readers/las.h.
class SCANREADERS_EXPORT vtkScanLasReader : public vtkScanReader
{
public:
  static vtkScanLasReader* New();
  vtkTypeMacro(vtkScanLasReader, vtkScanReader);
  vtkScanLasReader(const vtkScanLasReader&) = delete;
  void operator=(const vtkScanLasReader&) = delete;

protected:
  vtkScanLasReader() = default;
  ~vtkScanLasReader() override = default;

  scan::Model Parse(
    std::span<const char> bytes, std::string_view name, scan::Execution& execution) const override;
};
