// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/incidence.h"
#include "filters/geometry/mesh.h"

#include <optional>
#include <vector>

namespace scan
{

/// A point far out of its neighbours.
struct Spike
{
  Index point = 0;
  Vec3 middle;         ///< of its neighbours, where it would be smooth
  double height = 0.0; ///< above them, in model units
};

/// The triangles at every point; collapsed ones are left out.
Incidence trianglesAtPoints(const TriMesh& mesh);

/// Whether a point is a spike: its neighbours are a closed ring, the height over the plane of the
/// ring exceeds `ratio` times the mean radius of the ring, and beyond the ring the surface turns
/// away by more than 45 degrees along half of it. So the tip of a cone is none where the cone goes
/// on beyond the neighbours, nor is the corner of a box, however long the box is.
std::optional<Spike> spikeAt(
  const TriMesh& mesh, const Incidence& trianglesAt, Index point, double ratio);

/// All spikes, by their points. Which way triangles face does not count. Linear time.
std::vector<Spike> findSpikes(
  const TriMesh& mesh, const Incidence& trianglesAt, double ratio, Execution& execution);

} // namespace scan
