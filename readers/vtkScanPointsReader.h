// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "readers/vtkScanReader.h"

/// Reads vertex lists: .xyz .txt .asc .pts .csv .pwn. See readers/points_text.h.
class SCANREADERS_EXPORT vtkScanPointsReader : public vtkScanReader
{
public:
  static vtkScanPointsReader* New();
  vtkTypeMacro(vtkScanPointsReader, vtkScanReader);
  vtkScanPointsReader(const vtkScanPointsReader&) = delete;
  void operator=(const vtkScanPointsReader&) = delete;

protected:
  vtkScanPointsReader() = default;
  ~vtkScanPointsReader() override = default;

  scan::Model Parse(
    std::span<const char> bytes, std::string_view name, scan::Execution& execution) const override;
};
