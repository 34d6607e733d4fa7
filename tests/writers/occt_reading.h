// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/mesh.h"

#include <string>
#include <vector>

namespace scan::test
{

/// What OpenCASCADE finds in a CAD file, in millimetres.
struct CadContent
{
  int solids = 0;
  int shells = 0;
  int faces = 0;
  std::vector<Vec3> vertices; ///< distinct ones
  double volume = 0.0;
  double area = 0.0;
  double length = 0.0; ///< of the edges, once for each face or wire that has them
  bool isValid = false;
};

/// Throws std::runtime_error when the file holds no shape.
CadContent readIgesWithOcct(const std::string& path);

} // namespace scan::test
