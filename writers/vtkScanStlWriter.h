// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "writers/vtkScanWriter.h"

/// Writes surfaces as STL, binary or ascii. See writers/stl.h.
class SCANWRITERS_EXPORT vtkScanStlWriter : public vtkScanWriter
{
public:
  static vtkScanStlWriter* New();
  vtkTypeMacro(vtkScanStlWriter, vtkScanWriter);
  vtkScanStlWriter(const vtkScanStlWriter&) = delete;
  void operator=(const vtkScanStlWriter&) = delete;

protected:
  vtkScanStlWriter() = default;
  ~vtkScanStlWriter() override = default;

  void Format(
    const scan::Model& model, scan::OutputFile& file, scan::Execution& execution) const override;
  std::vector<scan::Vec3> Stored(const std::vector<scan::Vec3>& points) const override;
  std::string NoteOn(const scan::Model& model) const override;
};
