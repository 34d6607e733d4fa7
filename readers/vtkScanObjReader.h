// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "readers/vtkScanReader.h"

/// Reads vertices and faces of Wavefront files, .obj. See readers/obj.h.
class SCANREADERS_EXPORT vtkScanObjReader : public vtkScanReader
{
public:
  static vtkScanObjReader* New();
  vtkTypeMacro(vtkScanObjReader, vtkScanReader);
  vtkScanObjReader(const vtkScanObjReader&) = delete;
  void operator=(const vtkScanObjReader&) = delete;

protected:
  vtkScanObjReader() = default;
  ~vtkScanObjReader() override = default;

  scan::Model Parse(
    std::span<const char> bytes, std::string_view name, scan::Execution& execution) const override;
};
