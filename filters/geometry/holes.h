// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/mesh.h"

#include <vector>

namespace scan
{

/// A closed chain of edges with one triangle each: the rim of a hole, or of the surface itself.
struct BoundaryLoop
{
  std::vector<Index> points; ///< each once, the way that the triangles run
  std::vector<Index> halves; ///< per point: the half-edge from it to the next
  double length = 0.0;
  double outline = 0.0;   ///< the length without the small jags of the rim
  Vec3 place;             ///< the middle of the rim, by length
  double pieceArea = 0.0; ///< of the triangles that hang together with it by edges
  bool isLongest = false; ///< of the loops of this piece
  bool isManifold = true; ///< no edge with too many or misoriented triangles cuts the chain; where
                          ///< one does, the chain is not closed
};

/// The boundary of a mesh in simple loops, in the order of their smallest half-edges. Where chains
/// meet at a point, as those of two holes with a common corner do, they are parted there.
/// Collapsed triangles take no part. Linear time. Throws Error badInput for a missing point.
std::vector<BoundaryLoop> boundaryLoops(const TriMesh& mesh, Execution& execution);

/// Whether a loop rather bounds an open surface than a hole: it is the longest of its piece, and a
/// disk with its outline would have more than half the area of the piece. So a half sphere and
/// anything more closed has a hole, a sheet has none.
bool isOuterRim(const BoundaryLoop& loop);

} // namespace scan
