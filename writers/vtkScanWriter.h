// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/model.h"
#include "writers/encoding.h"
#include "writers/format_traits.h"
#include "writers/vtkScanFileWriter.h"

#include <string>

/// Base of the writers of models: makes a model of a vtkPolyData, mends its surface, and notes what
/// the file cannot hold. A subclass names its formatter in Format().
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

  /// What a file holds of this model, with the settings of the writer. Default: everything.
  virtual scan::FormatTraits Traits(const scan::Model& model) const;

  /// Writes the model, made ready as the traits of the input ask for, without committing the file.
  /// Throws scan::Error. Phase "write".
  virtual void Format(const scan::Model& model, const scan::FormatTraits& traits,
    scan::OutputFile& file, scan::Execution& execution) const = 0;

  /// One line on what the format does to the model, beside what the traits say; empty, the default,
  /// when nothing noteworthy.
  virtual std::string NoteOn(const scan::Model& model) const;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void WriteFile(vtkDataObject& input, scan::OutputFile& file, scan::Execution& execution) final;

  scan::Encoding Encoding = scan::Encoding::binary;
  bool Consistent = true;
};
