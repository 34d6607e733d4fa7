// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "readers/vtkScanReader.h"

/// Reads PTX scans. See readers/ptx.h.
class SCANREADERS_EXPORT vtkScanPtxReader : public vtkScanReader
{
public:
  static vtkScanPtxReader* New();
  vtkTypeMacro(vtkScanPtxReader, vtkScanReader);
  vtkScanPtxReader(const vtkScanPtxReader&) = delete;
  void operator=(const vtkScanPtxReader&) = delete;

protected:
  vtkScanPtxReader() = default;
  ~vtkScanPtxReader() override = default;

  scan::Model Parse(
    std::span<const char> bytes, std::string_view name, scan::Execution& execution) const override;
};
