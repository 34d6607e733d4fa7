// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "readers/vtkScanReader.h"

/// Reads 3D Studio meshes. See readers/autodesk_3ds.h.
class SCANREADERS_EXPORT vtkScanAutodesk3dsReader : public vtkScanReader
{
public:
  static vtkScanAutodesk3dsReader* New();
  vtkTypeMacro(vtkScanAutodesk3dsReader, vtkScanReader);
  vtkScanAutodesk3dsReader(const vtkScanAutodesk3dsReader&) = delete;
  void operator=(const vtkScanAutodesk3dsReader&) = delete;

protected:
  vtkScanAutodesk3dsReader() = default;
  ~vtkScanAutodesk3dsReader() override = default;

  scan::Model Parse(
    std::span<const char> bytes, std::string_view name, scan::Execution& execution) const override;
};
