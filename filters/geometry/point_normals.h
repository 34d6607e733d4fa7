// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/mesh.h"

#include <span>
#include <vector>

namespace scan
{

struct PointNormalOptions
{
  enum class Orient
  {
    outward, ///< agreeing with their neighbours, each connected part away from its inside
    toward,  ///< every normal to the side of `viewpoint`
    none     ///< as they come
  };
  Index neighbours = 16; ///< that suggest a plane, 3 to 1000
  Orient orient = Orient::outward;
  Vec3 viewpoint = {}; ///< where the scanner stood, model units
};

struct PointNormalResult
{
  std::vector<Vec3> normals; ///< per point, of length 1, or (0, 0, 0) where no plane is suggested
  std::size_t undecided = 0; ///< points without a normal
  std::size_t parts = 0;     ///< connected parts that were oriented
  std::size_t openParts = 0; ///< of these, parts that have no inside; their normals point up
};

/// Normals of the surface that points suggest: each of the plane that fits the point's neighbours
/// best.
///
/// To orient them, two neighbours agree when one normal is the mirror image of the other in the
/// plane between them, which is true on circles and across thin plates, too (Koenig, Gumhold 2009);
/// the surest pairs decide first (a minimal spanning tree as in Hoppe et al. 1992). A part is then
/// turned so that the volume it encloses is positive; where that is next to nothing, as for a
/// sheet, so that most normals have a positive z.
///
/// Equal points get equal normals; up to two distinct points and points on a line get none. About 4
/// s and 250 bytes a point for a million. Reports the phases "neighbours", "normals", "orient".
/// @throws Error{badInput} for points that are not finite
PointNormalResult pointNormals(
  std::span<const Vec3> points, const PointNormalOptions& options, Execution& execution);

} // namespace scan
