// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/edge_set.h"
#include "filters/geometry/fill_holes.h"
#include "filters/geometry/incidence.h"
#include "filters/geometry/loop_triangulation.h"
#include "filters/geometry/patch.h"

#include <optional>
#include <span>
#include <vector>

namespace scan
{

/// The polygon that a patch shall span: a loop of the boundary, or a part of one and a chord.
struct HolePolygon
{
  std::vector<Index> points; ///< as the triangles of the patch run
  std::vector<Index>
    beyond; ///< per edge to the next point: the triangle there, kNone for the chord
};

/// The surface that patches are made for.
class HoledSurface
{
public:
  HoledSurface(const TriMesh& mesh, const std::vector<HolePolygon>& holes);

  /// Diagonals that patches must not use: edges between points of rims, and what is added.
  EdgeSet taken;

  /// The patch that spans a polygon flatly. None when there is none.
  std::optional<Patch> flatPatch(const HolePolygon& hole, LoopAim aim, Execution& execution) const;

  /// A patch as dense as its rim that continues the surface, see FillShape. The chord gets points,
  /// too: those of the rim that are no points of the mesh, named after them. None when there is
  /// none.
  std::optional<Patch> smoothPatch(
    const HolePolygon& hole, FillShape shape, Execution& execution) const;

private:
  std::optional<Patch> triangulated(std::vector<Vec3> corners, std::vector<Index> names,
    std::span<const Index> beyond, LoopAim aim, Execution& execution) const;
  Vec3 normalOf(Index triangle) const;
  double spacingAt(Index point) const;
  void fair(int power, Patch& patch, Execution& execution) const;

  const TriMesh& Mesh;
  Incidence Around; // triangles of points
};

} // namespace scan
