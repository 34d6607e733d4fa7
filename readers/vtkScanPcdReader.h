// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "readers/vtkScanReader.h"

/// Reads PCD clouds. See readers/pcd.h.
class SCANREADERS_EXPORT vtkScanPcdReader : public vtkScanReader
{
public:
  static vtkScanPcdReader* New();
  vtkTypeMacro(vtkScanPcdReader, vtkScanReader);
  vtkScanPcdReader(const vtkScanPcdReader&) = delete;
  void operator=(const vtkScanPcdReader&) = delete;

protected:
  vtkScanPcdReader() = default;
  ~vtkScanPcdReader() override = default;

  scan::Model Parse(
    std::span<const char> bytes, std::string_view name, scan::Execution& execution) const override;
};
