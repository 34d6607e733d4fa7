// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "readers/vtkScanReader.h"

/// Reads OFF meshes. See readers/off.h.
class SCANREADERS_EXPORT vtkScanOffReader : public vtkScanReader
{
public:
  static vtkScanOffReader* New();
  vtkTypeMacro(vtkScanOffReader, vtkScanReader);
  vtkScanOffReader(const vtkScanOffReader&) = delete;
  void operator=(const vtkScanOffReader&) = delete;

protected:
  vtkScanOffReader() = default;
  ~vtkScanOffReader() override = default;

  scan::Model Parse(
    std::span<const char> bytes, std::string_view name, scan::Execution& execution) const override;
};
