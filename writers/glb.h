// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/model.h"
#include "writers/output_file.h"

#include <cstddef>

namespace scan
{

/// A primitive is about 150 bytes of JSON, and programs draw them one by one.
constexpr std::size_t kMostGlbCurves = 10000;

/// Writes a model as glTF 2.0 in one binary file (.glb); the caller commits the file.
///
/// One node with one mesh. The format holds coordinates as float32 in metres: the stored numbers
/// keep the model's unit, and the scale of the node, millimetresPerUnit / 1000, makes them metres
/// (a model without a unit counts as one in millimetres). `origin` is subtracted from them and
/// becomes the translation of the node, a float64: with that of originForFloats() what remains of
/// the rounding is about 6e-8 of the size of the model. The axes stay as they are; a viewer shows
/// +y upwards.
///
/// A scan becomes a mesh of points, a curve a strip or loop of lines; more than kMostGlbCurves
/// become one list of segments. Triangles have a material
/// that is no metal and visible from both sides. Colours become COLOR_0, linear light of 16 bits as
/// glTF wants it, from which the bytes come back; normals become NORMAL, one of length 0 that of
/// the surface. The same model gives the same bytes.
///
/// Throws Error badInput for a model without points; Error limit for coordinates beyond float32 and
/// for 4 GiB of data. Phase "write".
void writeGlb(const Model& model, const Vec3& origin, OutputFile& file, Execution& execution);

} // namespace scan
