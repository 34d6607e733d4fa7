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

  void Format(
    const scan::Model& model, scan::OutputFile& file, scan::Execution& execution) const override;
  std::vector<scan::Vec3> Stored(const std::vector<scan::Vec3>& points) const override;
  std::string NoteOn(const scan::Model& model) const override;

private:
  bool Version1 = false;
};
