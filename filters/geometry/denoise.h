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

struct DenoiseOptions
{
  double maxShift = 0.0; ///< model units: no point ends farther than this from where it was
  int iterations = 3;    ///< 1 or more
  Index neighbours = 32; ///< a surface is fitted to, 8 to 1000
};

struct DenoiseResult
{
  std::vector<Vec3> points;
  std::size_t moved = 0;
  std::size_t limited = 0;   ///< of these, stopped by maxShift
  double meanShift = 0.0;    ///< of the points of the region
  double largestShift = 0.0; ///< at most maxShift, exactly
};

/// Moves points onto the surface that their neighbours suggest: a quadric over the tangent plane,
/// fitted with weights that fall with the distance and with the angle between normals, so that a
/// curved surface does not shrink and an edge is fitted from the side a point belongs to (moving
/// least squares, Alexa et al. 2003; normals filtered bilaterally before). Points move along their
/// normals only, so they stay as dense as they were.
///
/// Points outside the region stay and count as neighbours. Equal points stay equal. Where fewer
/// than eight distinct points or no plane suggest a surface, points stay. About 7 s an iteration
/// for a million points on two cores. Reports the phases "neighbours" and "denoise".
/// @param inRegion per point 0 or 1
/// @throws Error{badInput} for points that are not finite
DenoiseResult denoise(std::span<const Vec3> points, std::span<const std::uint8_t> inRegion,
  const DenoiseOptions& options, Execution& execution);

} // namespace scan
