// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/affine.h"
#include "filters/geometry/mesh.h"

#include <span>
#include <vector>

namespace scan
{

struct AlignOptions
{
  std::vector<Vec3> from; ///< places on the scan that moves: none, or three or more
  std::vector<Vec3> onto; ///< where these belong, one for each
  bool fit = true;        ///< then move it to where it fits best
  int iterations = 100;   ///< of the fit, at most
  Index samples = 20000;  ///< points of the scan that are fitted, spread evenly, at most
};

struct AlignResult
{
  Affine motion;           ///< a rotation and a shift
  double pairRms = 0.0;    ///< distance of the picked pairs after the first placement, model units
  std::size_t samples = 0; ///< points of the moving scan that were tried
  std::size_t used = 0;    ///< of these, with a partner on the other scan in the end
  int iterations = 0;      ///< of the fit
  bool isSettled = false;  ///< whether the fit came to rest before its last iteration
  double rms = 0.0;        ///< distances of those used from the surface of their partners
  double mean = 0.0;
  double largest = 0.0;
  double angleDegrees = 0.0; ///< of the whole motion
  double shift = 0.0;        ///< of the middle of the moving points
};

/// Moves a scan rigidly onto another. Picked pairs give a first placement (least squares, Umeyama
/// 1991, without scaling); without pairs the scan starts where it is. The fit then repeats: every
/// sample gets the nearest point of the other scan as its partner; partners on a border, with
/// another direction of the surface or farther than three times the median count for nothing (so
/// a partial overlap is enough); and the sum of squared distances to the planes of the partners is
/// made least (Chen, Medioni 1992). Directions in which the surface slides on itself are left
/// alone.
///
/// About 3 s for two scans of a million points. Reports the phases "neighbours" and "fit".
/// @throws Error{badParameter} for pairs that do not decide a placement; Error{badInput} for points
///   that are not finite or scans that do not overlap anywhere
AlignResult align(std::span<const Vec3> moving, std::span<const Vec3> fixed,
  const AlignOptions& options, Execution& execution);

} // namespace scan
