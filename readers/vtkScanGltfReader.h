// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "readers/vtkScanReader.h"

/// Reads glTF 2.0 models, binary or as JSON with buffers that are embedded or lie beside the file.
/// See readers/gltf.h.
class SCANREADERS_EXPORT vtkScanGltfReader : public vtkScanReader
{
public:
  static vtkScanGltfReader* New();
  vtkTypeMacro(vtkScanGltfReader, vtkScanReader);
  vtkScanGltfReader(const vtkScanGltfReader&) = delete;
  void operator=(const vtkScanGltfReader&) = delete;

protected:
  vtkScanGltfReader() = default;
  ~vtkScanGltfReader() override = default;

  scan::Model Parse(
    std::span<const char> bytes, std::string_view name, scan::Execution& execution) const override;
};
