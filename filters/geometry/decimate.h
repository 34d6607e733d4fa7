// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/mesh.h"
#include "filters/geometry/surface_edit.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

namespace scan
{

struct DecimateOptions
{
  /// How many triangles to leave, of the whole mesh; 0: as few as maxDeviation allows.
  std::size_t triangles = 0;

  /// No point of either surface is farther from the other than that, in model units; 0 or more,
  /// infinity for no limit. Then fewer triangles may go than were asked for.
  double maxDeviation = std::numeric_limits<double>::infinity();

  /// Edges where the surface turns by more keep their line, as boundaries do. Degrees, 0 to 180.
  double creaseAngle = 90.0;

  /// Per triangle 1 where the mesh may change; empty: everywhere. The corners of the others stay.
  std::span<const std::uint8_t> isInRegion;
};

struct DecimateResult
{
  SurfaceEdit edit;
  std::size_t pointsMoved = 0; ///< of those that stay, from their places
  std::size_t rounds = 1;      ///< runs that it took until all promises held
  /// Pairs of triangles that meet in more than they share, though they did not in the input: none
  /// where the input has none.
  std::size_t intersections = 0;
};

/// Contracts edges by the quadric error (Garland, Heckbert 1997) to points in the best places, see
/// QuadricDecimation. The topology stays: handles, boundary loops, pieces; so a mesh of many pieces
/// keeps some triangles of each. No triangle turns over or becomes flat. Points where sheets touch
/// stay.
///
/// Where the result would intersect itself, though the input did not, or leave the limit
/// (trianglesBeyond(), both ways), contractions there are held back and all is done again; so a
/// limit is proved, and takes a few runs.
///
/// A point that is left is the nearest of those contracted into it.
///
/// Throws Error badParameter when there is neither a number nor a limit, badInput for a triangle
/// with a missing point or coordinates that are not finite; Cancelled. About a second and 200 MB
/// for a million triangles without a limit; the same result on any number of threads.
DecimateResult decimate(const TriMesh& mesh, const DecimateOptions& options, Execution& execution);

/// Throws what decimate() throws for a mesh and options that it cannot work with.
void requireDecimation(const TriMesh& mesh, const DecimateOptions& options);

} // namespace scan
