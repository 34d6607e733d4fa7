// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "writers/vtkScanWriter.h"

/// Writes surfaces as 3MF. See writers/threemf.h.
class SCANWRITERS_EXPORT vtkScanThreemfWriter : public vtkScanWriter
{
public:
  static vtkScanThreemfWriter* New();
  vtkTypeMacro(vtkScanThreemfWriter, vtkScanWriter);
  vtkScanThreemfWriter(const vtkScanThreemfWriter&) = delete;
  void operator=(const vtkScanThreemfWriter&) = delete;

protected:
  vtkScanThreemfWriter() = default;
  ~vtkScanThreemfWriter() override = default;

  void Format(
    const scan::Model& model, scan::OutputFile& file, scan::Execution& execution) const override;
  std::vector<scan::Vec3> Stored(const std::vector<scan::Vec3>& points) const override;
  std::string NoteOn(const scan::Model& model) const override;
};
