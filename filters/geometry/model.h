// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/note.h"
#include "filters/geometry/mesh.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace scan
{

/// Red, green, blue, 0 to 255.
using Color = std::array<std::uint8_t, 3>;

/// What a file holds: points, perhaps triangles and curves on them, and what else it says about the
/// points. Points without triangles and curves are a scan.
struct Model : TriMesh
{
  Polylines curves = {};
  std::vector<Color> colors = {};  ///< per point, or empty
  std::vector<Vec3> normals = {};  ///< per point, of length 1 or 0, or empty
  double millimetresPerUnit = 0.0; ///< of the coordinates; 0 when the file does not say
  std::string note = {}; ///< what the user should know about how the file was read; one line

  bool isScan() const { return this->triangles.empty() && this->curves.empty(); }

  /// An empty text adds nothing.
  void addNote(const std::string& text) { addToNote(this->note, text); }
};

} // namespace scan
