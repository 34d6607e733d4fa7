// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ScanWritersModule.h" // export macro
#include "filters/base/vtkScanTask.h"

#include <vtkWriter.h>

/// Writes a vtkPolyData as VTK XML PolyData, .vtp, with all its cells and arrays, exactly: binary,
/// compressed by zlib. The file appears under its name only when it is complete. FileName "-" is
/// standard output. The same data give the same bytes. Data without
/// points are Error badInput.
class SCANWRITERS_EXPORT vtkScanVtpWriter
  : public vtkWriter
  , public vtkScanTask
{
public:
  static vtkScanVtpWriter* New();
  vtkTypeMacro(vtkScanVtpWriter, vtkWriter);
  vtkScanVtpWriter(const vtkScanVtpWriter&) = delete;
  void operator=(const vtkScanVtpWriter&) = delete;
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The file to write; a file of that name is replaced.
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  /// @return 1 when the file is there, 0 after a failure or a cancel
  int Write() override;

protected:
  vtkScanVtpWriter() = default;
  ~vtkScanVtpWriter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  void WriteData() override;

private:
  char* FileName = nullptr;
};
