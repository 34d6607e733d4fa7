// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "writers/vtkScanWriter.h"

/// Writes points and surfaces as PLY, binary or ascii, without loss. See writers/ply.h.
class SCANWRITERS_EXPORT vtkScanPlyWriter : public vtkScanWriter
{
public:
  static vtkScanPlyWriter* New();
  vtkTypeMacro(vtkScanPlyWriter, vtkScanWriter);
  vtkScanPlyWriter(const vtkScanPlyWriter&) = delete;
  void operator=(const vtkScanPlyWriter&) = delete;

protected:
  vtkScanPlyWriter() = default;
  ~vtkScanPlyWriter() override = default;

  void Format(const scan::Model& model, const scan::FormatTraits& traits, scan::OutputFile& file,
    scan::Execution& execution) const override;
};
