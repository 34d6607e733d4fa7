// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/affine.h"
#include "filters/geometry/mesh.h"
#include "readers/xml_scanner.h"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace scan
{

/// An object where another one, or the build, shows it.
struct ThreemfUse
{
  std::string part; ///< empty: the same
  std::uint32_t object = 0;
  Affine place;
};

struct ThreemfObject
{
  TriMesh mesh;
  std::vector<ThreemfUse> components;
};

/// What one part of a 3MF file says.
struct ThreemfPart
{
  double millimetresPerUnit = 1.0;
  std::map<std::uint32_t, ThreemfObject> objects;
  std::vector<ThreemfUse> items; ///< of the build
};

/// Reads the XML of a model.
/// @param budget bytes that all parts of a file may take; what this one takes is subtracted
/// Throws Error parse, with part and line, and when the budget is exhausted.
ThreemfPart parseThreemfPart(XmlScanner& xml, std::size_t& budget);

} // namespace scan
