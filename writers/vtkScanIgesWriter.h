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

  ///@{
  /// What one unit is declared to be. Default: what the model says.
  vtkSetEnumMacro(Unit, scan::IgesUnit);
  vtkGetEnumMacro(Unit, scan::IgesUnit);
  ///@}

protected:
  vtkScanIgesWriter() = default;
  ~vtkScanIgesWriter() override = default;

  void Format(
    const scan::Model& model, scan::OutputFile& file, scan::Execution& execution) const override;

private:
  scan::IgesEntities Entities = scan::IgesEntities::faces;
  scan::IgesUnit Unit = scan::IgesUnit::model;
};
