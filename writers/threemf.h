// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/model.h"
#include "writers/output_file.h"

namespace scan
{

/// Writes the triangles as 3MF (3D Manufacturing Format, core specification), with every digit; the
/// caller commits the file.
///
/// The file has one object, and the unit that millimetresPerUnit says: micron, millimeter,
/// centimeter, inch, foot or meter; millimetres for 0, and for any other unit with a transform that
/// scales. Programs read coordinates as float32: `origin` is subtracted from them, and the
/// transform adds it again; that of originForFloats() keeps the rounding small. Points that no
/// triangle uses are left out; colours and normals have no place in the core format. The same model
/// gives the same bytes on any number of threads.
///
/// Throws Error badInput without triangles and for a triangle that uses a point twice, which the
/// format forbids; Error limit for coordinates beyond 1e9 and for 4 GiB of text, about 60 million
/// triangles. Phase "write".
void writeThreemf(const Model& model, const Vec3& origin, OutputFile& file, Execution& execution);

} // namespace scan
