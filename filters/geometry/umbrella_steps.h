// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/point_links.h"

#include <cstdint>
#include <limits>
#include <span>
#include <string_view>
#include <vector>

namespace scan
{

struct UmbrellaSteps
{
  int pairs = 1;       ///< of steps
  double lambda = 0.7; ///< weight of the first step of a pair
  double mu = -0.705;  ///< of the second; (1 - 2 lambda) (1 - 2 mu) is not below -1
  /// Model units: after each pair no point is farther from its home.
  double limit = std::numeric_limits<double>::infinity();
};

/// A surface whose points move.
struct UmbrellaSurface
{
  const TriMesh& mesh;
  const PointLists& triangles;           ///< per point
  const PointLists& neighbours;          ///< per point those that it moves towards; none: it stays
  std::span<const std::uint8_t> isSharp; ///< per point 1 where no plane touches the surface
  std::span<const Vec3> homes;           ///< where the points were before this and other operations
};

/// Moves every point towards the mean of its neighbours, all at once, by a weight, again and again
/// (Taubin 1995). A point without neighbours stays, bit for bit.
///
/// On a curved surface the mean of the neighbours is below the surface, the farther the longer the
/// edges: on triangles of many sizes that would dent and swell it by as much as the noise. So a
/// neighbour counts as it were if the surface were flat: without the part of its height that the
/// turn of the normal explains, half of it times the edge, exact for arcs. Normals are
/// SmoothNormals, computed anew while the points move.
///
/// What many steps do is a polynomial of the mean of neighbours. Without a limit it is summed as a
/// Chebyshev series of far fewer terms; with one, steps are taken one by one.
///
/// Exact to some 1e-6 of the movement, as displacements are single-precision numbers, not places.
std::vector<Vec3> umbrellaSteps(const UmbrellaSurface& surface, const UmbrellaSteps& steps,
  std::string_view phase, Execution& execution);

} // namespace scan
