// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/model_edit.h"

#include <span>

namespace scan
{

struct AngleRepairOptions
{
  double featureAngle = 30.0; ///< degrees in [0, 180): an edge that turns by more is a feature
  double gain = 0.02;         ///< in (0, 1): what a repair takes off the bend of its first
                              ///< tetrahedron, as a part of that, at least
};

struct AngleRepairReport : EditReport
{
  Index repairs = 0; ///< bites and bumps found, each a few tetrahedra that flip together
  Index flips = 0;   ///< tetrahedra removed or filled for them
};

/// Repairs bites along feature lines: kept tetrahedra at the surface are removed and gone ones
/// filled where that straightens the lines.
///
/// The bend of a surface is the sum over its edges of length times the angle by which it turns
/// there, the total absolute mean curvature. A tetrahedron with two triangles on the surface
/// flips one edge for another, one with one triangle brings its fourth vertex onto the surface; no
/// vertex is lost, and the new edge or vertex must not have been on the surface, which stays the
/// manifold that it was there. Up to four neighbouring tetrahedra flip together when the bend falls
/// by more than `gain`, and each of them has a feature edge before it flips: smooth parts stay as
/// they are. Where sheets or more than two triangles meet at an edge, nothing flips. Repeated until
/// nothing improves; ends since the bend falls.
/// Alboul, van Damme, "Polyhedral metrics in surface reconstruction: tight triangulations" (1997).
///
/// Of a region only tetrahedra flip whose triangles on the surface have all their vertices at
/// triangles of the region. Time follows the feature lines, after a look at every tetrahedron.
/// Reports phase "repair angles".
AngleRepairReport repairAngles(WrapModel& model, std::span<const Facet> region,
  const AngleRepairOptions& options, Execution& execution);

} // namespace scan
