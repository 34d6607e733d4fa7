// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/model.h"
#include "writers/output_file.h"

namespace scan
{

/// Writes points, triangles and curves ("l") as Wavefront OBJ, without loss; the caller commits the
/// file. A scan becomes a file of vertices only. Colours are reals of 0 to 1 behind the
/// coordinates, of four decimals, which give the same byte whether a reader rounds or cuts. Normals
/// are "vn", in the order of the vertices, and corners then are "a//a". The same model gives the
/// same bytes.
///
/// Throws Error badInput without points. Phase "write".
void writeObj(const Model& model, OutputFile& file, Execution& execution);

} // namespace scan
