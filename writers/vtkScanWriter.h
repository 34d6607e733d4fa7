// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/model.h"
#include "writers/encoding.h"
#include "writers/vtkScanFileWriter.h"

#include <string>
#include <vector>

/// Base of the writers of models: makes a model of a vtkPolyData and mends its surface. A subclass
/// names its formatter in Format().
class SCANWRITERS_EXPORT vtkScanWriter : public vtkScanFileWriter
{
public:
  vtkTypeMacro(vtkScanWriter, vtkScanFileWriter);
  vtkScanWriter(const vtkScanWriter&) = delete;
  void operator=(const vtkScanWriter&) = delete;
  void PrintSelf(ostream& os, vtkIndent indent) override;

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

protected:
  vtkScanWriter() = default;
  ~vtkScanWriter() override = default;

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
  void WriteFile(vtkDataObject& input, scan::OutputFile& file, scan::Execution& execution) final;

  scan::Encoding Encoding = scan::Encoding::binary;
  bool Consistent = true;
};
