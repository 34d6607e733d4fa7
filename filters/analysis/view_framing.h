// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/mesh.h"

#include <span>

namespace scan
{

/// Where to look from, and how much of the picture to leave free.
struct ViewOptions
{
  Vec3 towards = { 0.0, 0.0, 1.0 }; ///< from the model to the camera; any length but zero
  Vec3 up = { 0.0, 1.0, 0.0 };      ///< not along `towards`
  double aspect = 4.0 / 3.0;        ///< width of the picture / height
  double viewAngle = 25.0;          ///< degrees from bottom to top; 0 is a parallel projection
  double margin = 0.06;             ///< share of the half width or height that stays free
};

/// A camera in model units.
struct ViewFrame
{
  Vec3 position;
  Vec3 target; ///< in the middle of the model's depth
  Vec3 up;
  double halfHeight = 1.0; ///< of what the picture shows at the target
};

/// The nearest camera that shows all points, with the points in the middle of the picture. Exact in
/// either projection; one pass. There must be a point; one alone is shown in a picture of height 2.
ViewFrame frameView(std::span<const Vec3> points, const ViewOptions& options);

} // namespace scan
