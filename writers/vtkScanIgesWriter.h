// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "writers/iges.h"
#include "writers/vtkScanWriter.h"

/// Writes surfaces and points as IGES. See writers/iges.h.
class SCANWRITERS_EXPORT vtkScanIgesWriter : public vtkScanWriter
{
public:
  static vtkScanIgesWriter* New();
  vtkTypeMacro(vtkScanIgesWriter, vtkScanWriter);
  vtkScanIgesWriter(const vtkScanIgesWriter&) = delete;
  void operator=(const vtkScanIgesWriter&) = delete;

  ///@{
  /// What a triangle becomes. Default: faces.
  vtkSetEnumMacro(Entities, scan::IgesEntities);
  vtkGetEnumMacro(Entities, scan::IgesEntities);
  ///@}

protected:
  vtkScanIgesWriter() = default;
  ~vtkScanIgesWriter() override = default;

  scan::FormatTraits Traits(const scan::Model& model) const override;
  void Format(const scan::Model& model, const scan::FormatTraits& traits, scan::OutputFile& file,
    scan::Execution& execution) const override;
  std::string NoteOn(const scan::Model& model) const override;

private:
  scan::IgesEntities Entities = scan::IgesEntities::faces;
};
