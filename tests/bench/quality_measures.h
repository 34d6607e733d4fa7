// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/mesh_checks.h"

#include <optional>
#include <span>

namespace quality
{

/// Distances, in the unit that was asked for.
struct Deviation
{
  double mean = 0.0;
  double max = 0.0;
};

/// What a surface is worth.
struct Quality
{
  double pointsOnSurface = 0.0; ///< share of the distinct points that are corners of triangles
  Deviation ofPoints;           ///< of all points from the surface
  scan::MeshReport topology;
  std::optional<Deviation> fromTruth; ///< of the surface from the truth: what is too much
  std::optional<Deviation> ofTruth;   ///< of the truth from the surface: what is missing
};

/// Measures a surface with at least one triangle that is not flat.
///
/// Distances are exact from point to triangle. Surfaces are sampled at 100,000 places even by area,
/// which give the mean, and at all corners, which count for the maximum, too.
/// @param truth the true surface; may be null
/// @param unit the length that all distances are divided by
Quality measureQuality(const scan::TriMesh& surface, std::span<const scan::Vec3> points,
  const scan::TriMesh* truth, double unit);

} // namespace quality
