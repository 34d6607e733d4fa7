// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/mesh.h"

#include <TopoDS_Shape.hxx>

#include <string>
#include <vector>

namespace scan::test
{

/// 30 x 20 x 10 mm with a corner in the origin.
TopoDS_Shape boxPart();

/// Radius 10, height 30 along z, with a hole of radius 4 along x through the middle.
TopoDS_Shape drilledCylinderPart();

/// Radius 7 around (1, 2, 3).
TopoDS_Shape spherePart();

/// Around the z axis, radii 20 and 5.
TopoDS_Shape torusPart();

/// A ball of radius 7 with a hollow of radius 5.
TopoDS_Shape hollowBallPart();

/// A box twice: as it is, and mirrored at x = -10; 30 x 20 x 10 mm each.
TopoDS_Shape mirroredPairPart();

/// In millimetres.
std::string stepBytes(const TopoDS_Shape& shape);

/// @param unit "MM", "INCH", ...
/// @param isSolid as a boundary model; else as faces that do not know each other
std::string igesBytes(const TopoDS_Shape& shape, bool isSolid, const char* unit = "MM");

/// What OpenCASCADE finds in the file, without triangles.
TopoDS_Shape shapeOf(const std::string& path);

double volumeOf(const TopoDS_Shape& shape);

/// The largest distance of any of the points from the surface of the shape.
double distanceFrom(const TopoDS_Shape& shape, const std::vector<Vec3>& points);

} // namespace scan::test
