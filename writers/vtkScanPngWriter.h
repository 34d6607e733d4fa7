// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "writers/vtkScanFileWriter.h"

/// Writes a vtkImageData of 8 or 16 bits a channel as PNG; the file appears under its name only
/// when it is complete. Other pictures are Error badInput.
class SCANWRITERS_EXPORT vtkScanPngWriter : public vtkScanFileWriter
{
public:
  static vtkScanPngWriter* New();
  vtkTypeMacro(vtkScanPngWriter, vtkScanFileWriter);
  vtkScanPngWriter(const vtkScanPngWriter&) = delete;
  void operator=(const vtkScanPngWriter&) = delete;

protected:
  vtkScanPngWriter() = default;
  ~vtkScanPngWriter() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void WriteFile(vtkDataObject& input, scan::OutputFile& file, scan::Execution& execution) override;
};
