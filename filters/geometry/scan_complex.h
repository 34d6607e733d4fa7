// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/basins.h"
#include "filters/geometry/blocks.h"
#include "filters/geometry/size_scale.h"

#include <memory>
#include <mutex>
#include <span>

namespace scan
{

/// All that is computed once for a point set, shared by every wrap of it; never changed.
class ScanComplex
{
public:
  /// @throws as buildDelaunayComplex. Reports phases "triangulate", "classify", "basins".
  ScanComplex(std::span<const Vec3> points, Execution& execution);

  ScanComplex(const ScanComplex&) = delete;
  void operator=(const ScanComplex&) = delete;

  const DelaunayComplex& delaunay() const { return this->Delaunay; }
  const FlowComplex& flow() const { return this->Flow; }
  const Basins& basins() const { return this->TheBasins; }

  /// Found when first asked for; any thread may ask. Reports phase "blocks".
  const Blocks& blocks(Execution& execution) const;
  const SizeScale& sizes(Execution& execution) const;

private:
  DelaunayComplex Delaunay;
  FlowComplex Flow;
  Basins TheBasins;
  mutable std::mutex Guard;
  mutable std::unique_ptr<const Blocks> TheBlocks;
  mutable std::unique_ptr<const SizeScale> TheSizes;
};

} // namespace scan
