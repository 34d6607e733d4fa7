// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "writers/vtkScanWriter.h"

/// Writes points and triangles as VRML97 or VRML 1.0. See writers/vrml97.h and
/// writers/inventor.h.
class SCANWRITERS_EXPORT vtkScanVrmlWriter : public vtkScanWriter
{
public:
  static vtkScanVrmlWriter* New();
  vtkTypeMacro(vtkScanVrmlWriter, vtkScanWriter);
  vtkScanVrmlWriter(const vtkScanVrmlWriter&) = delete;
  void operator=(const vtkScanVrmlWriter&) = delete;

  ///@{
  /// VRML 1.0 instead of VRML97. Default: off.
  vtkSetMacro(Version1, bool);
  vtkGetMacro(Version1, bool);
  vtkBooleanMacro(Version1, bool);
  ///@}

protected:
  vtkScanVrmlWriter() = default;
  ~vtkScanVrmlWriter() override = default;

  scan::FormatTraits Traits(const scan::Model& model) const override;
  void Format(const scan::Model& model, const scan::FormatTraits& traits, scan::OutputFile& file,
    scan::Execution& execution) const override;

private:
  bool Version1 = false;
};
