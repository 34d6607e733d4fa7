// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "readers/vtkScanReader.h"

/// Reads 3MF models. See readers/threemf.h.
class SCANREADERS_EXPORT vtkScanThreemfReader : public vtkScanReader
{
public:
  static vtkScanThreemfReader* New();
  vtkTypeMacro(vtkScanThreemfReader, vtkScanReader);
  vtkScanThreemfReader(const vtkScanThreemfReader&) = delete;
  void operator=(const vtkScanThreemfReader&) = delete;

protected:
  vtkScanThreemfReader() = default;
  ~vtkScanThreemfReader() override = default;

  scan::Model Parse(
    std::span<const char> bytes, std::string_view name, scan::Execution& execution) const override;
};
