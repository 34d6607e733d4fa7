// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/scan_complex.h"
#include "filters/geometry/wrap_complex.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace scan
{

/// A wrap that can be edited: a point set's complex and which part of it is kept now. Copies share
/// the complex; a new state takes a byte a tetrahedron.
struct WrapModel
{
  std::shared_ptr<const ScanComplex> scan;
  std::shared_ptr<const WrapComplex> start;   ///< as the wrap made it
  std::shared_ptr<const WrapComplex> current; ///< after the edits

  /// Edges that are kept without a triangle (classic mode), sorted by their vertices.
  std::shared_ptr<const std::vector<CriticalEdge>> lines;

  /// Per tetrahedron 0 or 1, what the automatic wrap found: tells the sides of its sheets. Null in
  /// classic mode.
  std::shared_ptr<const std::vector<std::uint8_t>> inside;

  /// The surface bounds solids and nothing else, and edits keep it so: the closed automatic wrap.
  bool isSolid = false;
};

} // namespace scan
