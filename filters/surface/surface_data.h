// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/surface_edit.h"

#include <vtkType.h>

#include <span>

class vtkPolyData;

namespace scan
{

/// Makes `output` the edited surface of `input`, as triangles, with its data:
/// - a point that stays keeps its data, wherever it moves; a new one has the mean that its blend
///   says of real numbers and colours, of anything else what the point with the largest weight has;
/// - ScanPointId of a new point is -1; normals are made anew from the triangles;
/// - a triangle has the data of the cell that it comes from; a new one NaN, -1 or what is largest
/// in
///   a type without both.
/// Lines and vertices are left out.
/// @param cells of the triangles of the input, as bridge::meshOf() tells
void setSurface(vtkPolyData& input, const SurfaceEdit& edit, std::span<const vtkIdType> cells,
  vtkPolyData& output);

} // namespace scan
