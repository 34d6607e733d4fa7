// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/mesh.h"
#include "readers/source.h"

class Message_ProgressRange;
class TopoDS_Shape;

namespace scan
{

/// Makes the faces of a shape triangles, in the order of the shape.
///
/// Points of edges and vertices are shared as the topology tells, within a solid, and among
/// everything that is in no solid. Solids and closed shells face outwards.
/// @param deflection largest distance from the surface
/// @param angle largest turn along an edge, in radians
/// @throws Error{parse} when a face that is not vanishing has no triangles
TriMesh tessellate(const TopoDS_Shape& shape, double deflection, double angle, const Source& source,
  const Message_ProgressRange& progress);

} // namespace scan
