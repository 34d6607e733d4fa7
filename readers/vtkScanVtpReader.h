// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "readers/vtkScanReader.h"

/// Reads the points, faces and lines of VTK XML PolyData, .vtp, by VTK's reader in a process of its
/// own, which a cancel ends within 0.1 s.
///
/// Polygons and strips become triangles, lines curves; vertices are left out. Colours, normals
/// and the unit come from the arrays that vtkScanVtpWriter writes; other arrays are left out.
///
/// Error parse, with VTK's words, for a file that is malformed, cut off or without points, for
/// faces that name a point that is not there, and for coordinates that are not finite or exceed
/// 1e50.
class SCANREADERS_EXPORT vtkScanVtpReader : public vtkScanReader
{
public:
  static vtkScanVtpReader* New();
  vtkTypeMacro(vtkScanVtpReader, vtkScanReader);
  vtkScanVtpReader(const vtkScanVtpReader&) = delete;
  void operator=(const vtkScanVtpReader&) = delete;

protected:
  vtkScanVtpReader() = default;
  ~vtkScanVtpReader() override = default;

  scan::Model Parse(
    std::span<const char> bytes, std::string_view name, scan::Execution& execution) const override;
};
