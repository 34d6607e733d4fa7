// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ScanWritersModule.h" // export macro
#include "filters/base/vtkScanTask.h"

#include <vtkWriter.h>

namespace scan
{
class OutputFile;
}

/// Base of all writers: names the file, guards the work, and lets the file appear under its name
/// only when it is complete. FileName "-" is standard output. A subclass writes the file in
/// WriteFile().
class SCANWRITERS_EXPORT vtkScanFileWriter
  : public vtkWriter
  , public vtkScanTask
{
public:
  vtkTypeMacro(vtkScanFileWriter, vtkWriter);
  vtkScanFileWriter(const vtkScanFileWriter&) = delete;
  void operator=(const vtkScanFileWriter&) = delete;
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The file to write; a file of that name is replaced.
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  /// @return 1 when the file is there, 0 after a failure or a cancel
  int Write() override;

protected:
  vtkScanFileWriter() = default;
  ~vtkScanFileWriter() override;

  /// Writes the data, which are of the type that the input port takes, without committing the file.
  /// Throws scan::Error. Phase "write".
  virtual void WriteFile(
    vtkDataObject& input, scan::OutputFile& file, scan::Execution& execution) = 0;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) final;
  void WriteData() final;

private:
  char* FileName = nullptr;
};
