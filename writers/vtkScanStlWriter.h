// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "writers/vtkScanWriter.h"

/// Writes surfaces as STL, binary or ascii. See writers/stl.h.
class SCANWRITERS_EXPORT vtkScanStlWriter : public vtkScanWriter
{
public:
  static vtkScanStlWriter* New();
  vtkTypeMacro(vtkScanStlWriter, vtkScanWriter);
  vtkScanStlWriter(const vtkScanStlWriter&) = delete;
  void operator=(const vtkScanStlWriter&) = delete;

protected:
  vtkScanStlWriter() = default;
  ~vtkScanStlWriter() override = default;

  scan::FormatTraits Traits(const scan::Model& model) const override;
  void Format(const scan::Model& model, const scan::FormatTraits& traits, scan::OutputFile& file,
    scan::Execution& execution) const override;
};
