// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ScanWritersModule.h" // export macro
#include "filters/base/vtkScanTask.h"
#include "filters/geometry/model.h"
#include "writers/encoding.h"

#include <vtkWriter.h>

#include <string>
#include <vector>

namespace scan
{
class OutputFile;
}

/// Base of the writers of vtkPolyData: guards the formatter; the file appears under its name only
/// when it is complete. A subclass names its formatter in Format(). FileName "-" is standard
/// output.
class SCANWRITERS_EXPORT vtkScanWriter
  : public vtkWriter
  , public vtkScanTask
{
public:
  vtkTypeMacro(vtkScanWriter, vtkWriter);
  vtkScanWriter(const vtkScanWriter&) = delete;
  void operator=(const vtkScanWriter&) = delete;
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The file to write; a file of that name is replaced.
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /// Whether to mend surfaces: what is written is then an oriented manifold without triangles that
  /// have no area, see writers/consistent_model.h. The note says what was changed. Default: true.
  vtkSetMacro(Consistent, bool);
  vtkGetMacro(Consistent, bool);
  vtkBooleanMacro(Consistent, bool);
  ///@}

  ///@{
  /// Binary or ascii, where the format has both. Default: binary.
  vtkSetEnumMacro(Encoding, scan::Encoding);
  vtkGetEnumMacro(Encoding, scan::Encoding);
  ///@}

  /// @return 1 when the file is there, 0 after a failure or a cancel
  int Write() override;

protected:
  vtkScanWriter() = default;
  ~vtkScanWriter() override;

  /// Writes the model without committing the file. Throws scan::Error. Phase "write".
  virtual void Format(
    const scan::Model& model, scan::OutputFile& file, scan::Execution& execution) const = 0;

  /// The points as the file will hold them, up to a translation; none, the default, where it keeps
  /// every digit.
  virtual std::vector<scan::Vec3> Stored(const std::vector<scan::Vec3>& points) const;

  /// Triangles that are not higher have no area for the format. Default: 0, exactly none.
  virtual double LeastHeight(const scan::Model& model) const;

  /// One line on what the format does to the model; empty, the default, when nothing noteworthy.
  virtual std::string NoteOn(const scan::Model& model) const;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) final;
  void WriteData() final;

  char* FileName = nullptr;
  scan::Encoding Encoding = scan::Encoding::binary;
  bool Consistent = true;
};
