// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "readers/vtkScanReader.h"

/// Reads the surfaces of STEP and IGES files as triangles; the content tells which it is. See
/// readers/cad.h.
class SCANREADERS_EXPORT vtkScanCadReader : public vtkScanReader
{
public:
  static vtkScanCadReader* New();
  vtkTypeMacro(vtkScanCadReader, vtkScanReader);
  vtkScanCadReader(const vtkScanCadReader&) = delete;
  void operator=(const vtkScanCadReader&) = delete;
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Largest distance between the triangles and the surfaces, in millimetres; 0, the default: the
  /// relative one counts.
  vtkSetMacro(Tolerance, double);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /// The same as a fraction of the diagonal of the bounding box. Default: 0.001.
  vtkSetMacro(RelativeTolerance, double);
  vtkGetMacro(RelativeTolerance, double);
  ///@}

protected:
  vtkScanCadReader() = default;
  ~vtkScanCadReader() override = default;

  scan::Model Parse(
    std::span<const char> bytes, std::string_view name, scan::Execution& execution) const override;

private:
  double Tolerance = 0.0;
  double RelativeTolerance = 1e-3;
};
