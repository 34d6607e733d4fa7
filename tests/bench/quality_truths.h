// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/mesh.h"

namespace quality
{

/// The surfaces behind the sample scans as fine meshes: vertices exact, triangles off by less than
/// a hundredth of the scans' spacing.
scan::TriMesh torusSurface();  ///< radii 1 and 0.35
scan::TriMesh sphereSurface(); ///< radius 1
scan::TriMesh plateSurface();  ///< 4 x 4 x 1 with a hole of radius 0.6
scan::TriMesh saddleSurface(); ///< z = r^3 cos(3 a) / 2 over the unit disk
scan::TriMesh helixSurface();  ///< the helicoid of half-width 1, one turn, height 2
scan::TriMesh linkSurface();   ///< data/multiview_scan_truth.h

} // namespace quality
