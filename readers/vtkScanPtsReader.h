// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "readers/vtkScanReader.h"

/// Reads PTS scans. See readers/pts.h.
class SCANREADERS_EXPORT vtkScanPtsReader : public vtkScanReader
{
public:
  static vtkScanPtsReader* New();
  vtkTypeMacro(vtkScanPtsReader, vtkScanReader);
  vtkScanPtsReader(const vtkScanPtsReader&) = delete;
  void operator=(const vtkScanPtsReader&) = delete;

protected:
  vtkScanPtsReader() = default;
  ~vtkScanPtsReader() override = default;

  scan::Model Parse(
    std::span<const char> bytes, std::string_view name, scan::Execution& execution) const override;
};
