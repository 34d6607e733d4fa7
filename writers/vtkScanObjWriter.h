// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "writers/vtkScanWriter.h"

/// Writes points and surfaces as Wavefront OBJ, always text. See writers/obj.h.
class SCANWRITERS_EXPORT vtkScanObjWriter : public vtkScanWriter
{
public:
  static vtkScanObjWriter* New();
  vtkTypeMacro(vtkScanObjWriter, vtkScanWriter);
  vtkScanObjWriter(const vtkScanObjWriter&) = delete;
  void operator=(const vtkScanObjWriter&) = delete;

protected:
  vtkScanObjWriter() = default;
  ~vtkScanObjWriter() override = default;

  void Format(const scan::Model& model, const scan::FormatTraits& traits, scan::OutputFile& file,
    scan::Execution& execution) const override;
};
