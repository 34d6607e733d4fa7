// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/mesh.h"

namespace scan
{

/// What becomes of the digits of coordinates.
enum class Precision
{
  float64,             ///< all stay
  float32,             ///< the file holds float32
  float64ReadAsFloat32 ///< all are in the file, and most programs keep a float32 of them
};

/// What a file will hold of a model: decides how the model is made ready for it.
struct FormatTraits
{
  bool hasTriangles = true;
  bool hasLoosePoints = true; ///< points that neither a triangle nor a curve uses, beside such
  Precision precision = Precision::float64;
  Vec3 origin = {};         ///< what float32 are relative to
  double leastHeight = 0.0; ///< triangles that are not higher have no area; 0: exactly none
};

} // namespace scan
