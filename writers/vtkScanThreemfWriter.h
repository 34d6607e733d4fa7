// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "writers/vtkScanWriter.h"

/// Writes surfaces as 3MF. See writers/threemf.h.
class SCANWRITERS_EXPORT vtkScanThreemfWriter : public vtkScanWriter
{
public:
  static vtkScanThreemfWriter* New();
  vtkTypeMacro(vtkScanThreemfWriter, vtkScanWriter);
  vtkScanThreemfWriter(const vtkScanThreemfWriter&) = delete;
  void operator=(const vtkScanThreemfWriter&) = delete;

protected:
  vtkScanThreemfWriter() = default;
  ~vtkScanThreemfWriter() override = default;

  scan::FormatTraits Traits(const scan::Model& model) const override;
  void Format(const scan::Model& model, const scan::FormatTraits& traits, scan::OutputFile& file,
    scan::Execution& execution) const override;
  std::string NoteOn(const scan::Model& model) const override;
};
