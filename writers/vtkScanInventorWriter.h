// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "writers/vtkScanWriter.h"

/// Writes points and triangles as Open Inventor. See writers/inventor.h.
class SCANWRITERS_EXPORT vtkScanInventorWriter : public vtkScanWriter
{
public:
  static vtkScanInventorWriter* New();
  vtkTypeMacro(vtkScanInventorWriter, vtkScanWriter);
  vtkScanInventorWriter(const vtkScanInventorWriter&) = delete;
  void operator=(const vtkScanInventorWriter&) = delete;

protected:
  vtkScanInventorWriter() = default;
  ~vtkScanInventorWriter() override = default;

  scan::FormatTraits Traits(const scan::Model& model) const override;
  void Format(const scan::Model& model, const scan::FormatTraits& traits, scan::OutputFile& file,
    scan::Execution& execution) const override;
};
