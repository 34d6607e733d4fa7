// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "writers/vtkScanWriter.h"

/// Writes surfaces as 3D Studio meshes. See writers/autodesk_3ds.h.
class SCANWRITERS_EXPORT vtkScanAutodesk3dsWriter : public vtkScanWriter
{
public:
  static vtkScanAutodesk3dsWriter* New();
  vtkTypeMacro(vtkScanAutodesk3dsWriter, vtkScanWriter);
  vtkScanAutodesk3dsWriter(const vtkScanAutodesk3dsWriter&) = delete;
  void operator=(const vtkScanAutodesk3dsWriter&) = delete;

protected:
  vtkScanAutodesk3dsWriter() = default;
  ~vtkScanAutodesk3dsWriter() override = default;

  scan::FormatTraits Traits(const scan::Model& model) const override;
  void Format(const scan::Model& model, const scan::FormatTraits& traits, scan::OutputFile& file,
    scan::Execution& execution) const override;
};
