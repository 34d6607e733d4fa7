// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/basins.h"
#include "filters/geometry/blocks.h"
#include "filters/geometry/collapse_graph.h"
#include "filters/geometry/size_scale.h"
#include "filters/geometry/wrap_complex.h"

#include <cstdint>
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

  /// From a complex that was built before. Reports phases "classify", "basins".
  /// @throws Error badInput when it is not whole, see isWhole()
  ScanComplex(DelaunayComplex complex, Execution& execution);

  ScanComplex(const ScanComplex&) = delete;
  void operator=(const ScanComplex&) = delete;

  const DelaunayComplex& delaunay() const { return this->Delaunay; }
  const FlowComplex& flow() const { return this->Flow; }
  const Basins& basins() const { return this->TheBasins; }

  /// Found when first asked for; any thread may ask. Reports phase "blocks".
  const Blocks& blocks(Execution& execution) const;
  const SizeScale& sizes(Execution& execution) const;

  /// What edits a state at once, for an edit that costs as much as so many tetrahedra one by one;
  /// null where that is the shorter way, or the state does not follow the flow: the result is the
  /// same. The graph is made when with this edit they will have taken about as long as that does,
  /// or by prepareEdits(). Reports phase "holders".
  const CollapseGraph* graphFor(
    const WrapComplex& kept, std::int64_t tets, Execution& execution) const;

  /// Makes all that edits need, so that the first one answers as fast as the others.
  void prepareEdits(Execution& execution) const;

private:
  const CollapseGraph& graph(Execution& execution) const;

  DelaunayComplex Delaunay;
  FlowComplex Flow;
  Basins TheBasins;
  mutable std::mutex Guard;
  mutable std::unique_ptr<const Blocks> TheBlocks;
  mutable std::unique_ptr<const SizeScale> TheSizes;
  mutable std::unique_ptr<const CollapseGraph> TheGraph;
  mutable std::int64_t EditedOneByOne = 0; ///< tetrahedra
};

} // namespace scan
