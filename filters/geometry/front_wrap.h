// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/mesh.h"

#include <span>
#include <vector>

namespace scan
{

/// Surface of a scan by CGAL's advancing front, with CGAL's default parameters: a second opinion to
/// compare the automatic wrap with. From seed triangles on, the most plausible Delaunay triangle at
/// the front joins the surface; what no triangle wants to cross stays open.
///
/// The triangles name points of the input; every edge has at most two of them, which agree about
/// the orientation, but nothing says which side is outside. Points may stay unused.
/// @param points finite and distinct, such as DelaunayComplex::points
/// @return empty for fewer than three points
/// @throws Cancelled while the front advances; the triangulation before it cannot be interrupted.
/// Equal edges of the front are taken in a fixed order, but on points that lie on few lines and
/// planes the library may still come out different from run to run.
/// Sequential, about 20 s and 1.5 kB a point per million points. Reports phase "front".
/// Cohen-Steiner, Da, "A greedy Delaunay-based surface reconstruction algorithm" (2004).
std::vector<Triangle> frontWrap(std::span<const Vec3> points, Execution& execution);

} // namespace scan
