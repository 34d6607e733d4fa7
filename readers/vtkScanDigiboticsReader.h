// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "readers/vtkScanReader.h"

/// Reads Digibotics contours. See readers/digibotics.h.
class SCANREADERS_EXPORT vtkScanDigiboticsReader : public vtkScanReader
{
public:
  static vtkScanDigiboticsReader* New();
  vtkTypeMacro(vtkScanDigiboticsReader, vtkScanReader);
  vtkScanDigiboticsReader(const vtkScanDigiboticsReader&) = delete;
  void operator=(const vtkScanDigiboticsReader&) = delete;

protected:
  vtkScanDigiboticsReader() = default;
  ~vtkScanDigiboticsReader() override = default;

  scan::Model Parse(
    std::span<const char> bytes, std::string_view name, scan::Execution& execution) const override;
};
