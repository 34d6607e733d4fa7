// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "writers/vtkScanWriter.h"

/// Writes points as text. See writers/xyz.h.
class SCANWRITERS_EXPORT vtkScanXyzWriter : public vtkScanWriter
{
public:
  static vtkScanXyzWriter* New();
  vtkTypeMacro(vtkScanXyzWriter, vtkScanWriter);
  vtkScanXyzWriter(const vtkScanXyzWriter&) = delete;
  void operator=(const vtkScanXyzWriter&) = delete;

protected:
  vtkScanXyzWriter() = default;
  ~vtkScanXyzWriter() override = default;

  scan::FormatTraits Traits(const scan::Model& model) const override;
  void Format(const scan::Model& model, const scan::FormatTraits& traits, scan::OutputFile& file,
    scan::Execution& execution) const override;
};
