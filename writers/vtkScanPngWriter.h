// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ScanWritersModule.h" // export macro
#include "filters/base/vtkScanTask.h"

#include <vtkWriter.h>

/// Writes a picture, a vtkImageData of unsigned char, as PNG; the file appears under its name only
/// when it is complete. FileName "-" is standard output.
class SCANWRITERS_EXPORT vtkScanPngWriter
  : public vtkWriter
  , public vtkScanTask
{
public:
  static vtkScanPngWriter* New();
  vtkTypeMacro(vtkScanPngWriter, vtkWriter);
  vtkScanPngWriter(const vtkScanPngWriter&) = delete;
  void operator=(const vtkScanPngWriter&) = delete;
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The file to write; a file of that name is replaced.
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

protected:
  vtkScanPngWriter() = default;
  ~vtkScanPngWriter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  void WriteData() override;

private:
  char* FileName = nullptr;
};
