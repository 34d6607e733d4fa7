// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "writers/dxf.h"
#include "writers/vtkScanWriter.h"

/// Writes points and triangles as DXF. See writers/dxf.h.
class SCANWRITERS_EXPORT vtkScanDxfWriter : public vtkScanWriter
{
public:
  static vtkScanDxfWriter* New();
  vtkTypeMacro(vtkScanDxfWriter, vtkScanWriter);
  vtkScanDxfWriter(const vtkScanDxfWriter&) = delete;
  void operator=(const vtkScanDxfWriter&) = delete;

  ///@{
  /// How triangles are held. Default: a 3DFACE each.
  vtkSetEnumMacro(Faces, scan::DxfFaces);
  vtkGetEnumMacro(Faces, scan::DxfFaces);
  ///@}

protected:
  vtkScanDxfWriter() = default;
  ~vtkScanDxfWriter() override = default;

  scan::FormatTraits Traits(const scan::Model& model) const override;
  void Format(const scan::Model& model, const scan::FormatTraits& traits, scan::OutputFile& file,
    scan::Execution& execution) const override;

private:
  scan::DxfFaces Faces = scan::DxfFaces::face3d;
};
