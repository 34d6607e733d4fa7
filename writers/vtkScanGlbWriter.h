// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "writers/vtkScanWriter.h"

/// Writes points and triangles as binary glTF. See writers/glb.h.
class SCANWRITERS_EXPORT vtkScanGlbWriter : public vtkScanWriter
{
public:
  static vtkScanGlbWriter* New();
  vtkTypeMacro(vtkScanGlbWriter, vtkScanWriter);
  vtkScanGlbWriter(const vtkScanGlbWriter&) = delete;
  void operator=(const vtkScanGlbWriter&) = delete;

protected:
  vtkScanGlbWriter() = default;
  ~vtkScanGlbWriter() override = default;

  scan::FormatTraits Traits(const scan::Model& model) const override;
  void Format(const scan::Model& model, const scan::FormatTraits& traits, scan::OutputFile& file,
    scan::Execution& execution) const override;
  std::string NoteOn(const scan::Model& model) const override;
};
