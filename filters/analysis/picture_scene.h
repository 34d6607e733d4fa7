// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/analysis/view_framing.h"
#include "filters/base/execution.h"
#include "filters/geometry/mesh.h"

#include <array>
#include <span>
#include <string>

class vtkRenderer;

namespace scan
{

using Rgb = std::array<double, 3>; ///< red, green, blue in [0, 1]

/// Colour of an HTML name or "#rrggbb". Throws Error badParameter for anything else.
Rgb parseColor(const std::string& text);

/// How a model looks.
struct PictureStyle
{
  Rgb front = { 0.87, 0.71, 0.58 }; ///< clay
  Rgb back = { 0.44, 0.62, 0.76 };  ///< of triangles seen from behind
  bool edges = false;
  double lineWidth = 1.0; ///< pixels
  double pointSize = 3.0; ///< pixels; for a model without triangles and lines
};

/// Puts the model into the renderer, with lights that follow the camera. Points alone are shaded
/// like the surface that their neighbours suggest, seen from the eye. Model coordinates should be
/// near the origin: graphics have single precision. Reports and checks the phase "shade".
void addModel(vtkRenderer& renderer, const TriMesh& mesh, std::span<const Segment> lines,
  const PictureStyle& style, const Vec3& eye, Execution& execution);

/// Sets the renderer's camera; call it after addModel. An angle of 0 is a parallel projection.
void aimCamera(vtkRenderer& renderer, const ViewFrame& frame, double viewAngle);

} // namespace scan
