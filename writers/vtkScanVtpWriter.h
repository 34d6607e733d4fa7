// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "writers/vtkScanFileWriter.h"

/// Writes a vtkPolyData as VTK XML PolyData, .vtp, with all its cells and arrays, exactly: binary,
/// compressed by zlib. The same data give the same bytes. Data without points are Error badInput.
class SCANWRITERS_EXPORT vtkScanVtpWriter : public vtkScanFileWriter
{
public:
  static vtkScanVtpWriter* New();
  vtkTypeMacro(vtkScanVtpWriter, vtkScanFileWriter);
  vtkScanVtpWriter(const vtkScanVtpWriter&) = delete;
  void operator=(const vtkScanVtpWriter&) = delete;
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Whether to mend surfaces, see filters/geometry/consistent_surface.h. Polygons and strips then
  /// become triangles; points stay and copies follow; all arrays are kept. Surfaces that are fine
  /// are written as they are. Default: true.
  vtkSetMacro(Consistent, bool);
  vtkGetMacro(Consistent, bool);
  vtkBooleanMacro(Consistent, bool);
  ///@}

protected:
  vtkScanVtpWriter() = default;
  ~vtkScanVtpWriter() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void WriteFile(vtkDataObject& input, scan::OutputFile& file, scan::Execution& execution) override;

private:
  bool Consistent = true;
};
