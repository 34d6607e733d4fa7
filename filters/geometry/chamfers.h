// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/mesh.h"

#include <cstdint>
#include <span>
#include <vector>

namespace scan
{

/// The strips that cut off the edges between smooth parts of a surface.
struct Chamfers
{
  std::vector<Index> mate;            ///< per half-edge, as in EdgePairs
  std::vector<std::uint8_t> isAcross; ///< per half-edge 1: leads from one smooth part to another
  std::vector<Vec3> normals; ///< per point: of the smooth part that it belongs to; zero for those
                             ///< in none or several
};

/// Finds them as Attene, Falcidieno, Rossignac, Spagnuolo (Edge-Sharpener, 2003) do. An edge is
/// smooth where its two triangles turn by no more than the angle. Triangles with a corner at which
/// all edges are smooth are smooth parts, and so is what hangs together with them by smooth edges.
/// The edges between other triangles that lead from a point of one part to a point of another go
/// across a chamfer. Both half-edges of an edge are marked. Linear time.
/// @param inRegion per triangle 1 for those that may belong to a chamfer
/// @param angle in radians
/// Throws Error as pairEdges().
Chamfers findChamfers(
  const TriMesh& mesh, std::span<const std::uint8_t> inRegion, double angle, Execution& execution);

} // namespace scan
