// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "writers/vtkScanWriter.h"

/// Writes points and triangles as OFF. See writers/off.h.
class SCANWRITERS_EXPORT vtkScanOffWriter : public vtkScanWriter
{
public:
  static vtkScanOffWriter* New();
  vtkTypeMacro(vtkScanOffWriter, vtkScanWriter);
  vtkScanOffWriter(const vtkScanOffWriter&) = delete;
  void operator=(const vtkScanOffWriter&) = delete;

protected:
  vtkScanOffWriter() = default;
  ~vtkScanOffWriter() override = default;

  void Format(const scan::Model& model, const scan::FormatTraits& traits, scan::OutputFile& file,
    scan::Execution& execution) const override;
};
