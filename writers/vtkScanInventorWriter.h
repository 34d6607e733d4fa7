// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "writers/vtkScanWriter.h"

/// Writes points and triangles as Open Inventor. See writers/inventor.h.
class SCANWRITERS_EXPORT vtkScanInventorWriter : public vtkScanWriter
{
public:
  static vtkScanInventorWriter* New();
  vtkTypeMacro(vtkScanInventorWriter, vtkScanWriter);
  vtkScanInventorWriter(const vtkScanInventorWriter&) = delete;
  void operator=(const vtkScanInventorWriter&) = delete;

protected:
  vtkScanInventorWriter() = default;
  ~vtkScanInventorWriter() override = default;

  void Format(
    const scan::Model& model, scan::OutputFile& file, scan::Execution& execution) const override;
  std::vector<scan::Vec3> Stored(const std::vector<scan::Vec3>& points) const override;
  std::string NoteOn(const scan::Model& model) const override;
};
