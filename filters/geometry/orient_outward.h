// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/half_edges.h"
#include "filters/geometry/mesh.h"

#include <cstdint>
#include <span>
#include <vector>

namespace scan
{

/// Turns the smaller part of each piece in which neighbours disagree.
/// @param pairs of the mesh
void turnDissenters(TriMesh& mesh, const EdgePairs& pairs);

/// Turns closed pieces that face inwards and are in no other, with what is in them: voids stay
/// voids.
/// @param mate per half-edge, kNone at a boundary
void turnOutwards(TriMesh& mesh, std::span<const Index> mate, Execution& execution);

struct OrientOptions
{
  bool outward = true; ///< closed pieces shall face outwards
  bool flip = false;   ///< instead turn over every triangle of the region
};

struct OrientResult
{
  std::vector<Triangle> triangles;
  Index turned = 0;            ///< triangles
  Index pieces = 0;            ///< that hang together by edges of two triangles
  Index disagreeingPieces = 0; ///< of these with neighbours that disagree in the end: one-sided
                               ///< ones, or where a flip of a part ends
};

/// Makes neighbours agree which side is outside: the smaller part of each piece is turned. Then
/// closed pieces are turned outwards with those in them, see turnOutwards(). One-sided pieces keep
/// a seam. Only pieces with a triangle of the region change. Points stay. Linear time.
///
/// Throws Error badInput for a triangle that names a missing point; Cancelled.
/// @param inRegion per triangle 0 or 1
OrientResult orientSurface(const TriMesh& mesh, std::span<const std::uint8_t> inRegion,
  const OrientOptions& options, Execution& execution);

} // namespace scan
