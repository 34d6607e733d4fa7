// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/model.h"
#include "writers/output_file.h"

namespace scan
{

/// Writes the points as text, one a line, without loss; the caller commits the file. A line is
/// "x y z", then "r g b" from 0 to 255 where the model has colours, then "nx ny nz" where it has
/// normals. Of a surface the points are written, its triangles are not. The same model gives the
/// same bytes.
///
/// Throws Error badInput without points. Phase "write".
void writeXyz(const Model& model, OutputFile& file, Execution& execution);

} // namespace scan
