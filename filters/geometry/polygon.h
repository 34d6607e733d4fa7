// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/mesh.h"

#include <span>
#include <vector>

namespace scan
{

/// Appends the triangles of a polygon, which turn as it does and have its corners only.
///
/// A polygon that all of its points see from the first corner becomes the fan around that corner,
/// and any other the constrained Delaunay triangulation of its projection along the axis nearest to
/// its normal, with exact predicates: a concave polygon is filled inside its border alone. Holes
/// may be cut in along edges that are walked both ways. Of corners at the same place one is used. A
/// border that crosses or covers itself in the projection, a polygon without area and one with
/// corners that are no points become a fan. Time O(n log n) for n corners of usual shapes, O(n) for
/// fans; nothing for fewer than three.
void appendPolygon(
  std::vector<Triangle>& triangles, std::span<const Vec3> points, std::span<const Index> corners);

/// The same for several polygons, each a line through its corners.
void appendPolygons(
  std::vector<Triangle>& triangles, std::span<const Vec3> points, const Polylines& polygons);

/// Appends the triangles of a strip: its corners by threes, every second triple turned over.
void appendStrip(std::vector<Triangle>& triangles, std::span<const Index> corners);

} // namespace scan
