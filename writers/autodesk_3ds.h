// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/model.h"
#include "writers/output_file.h"

namespace scan
{

/// Writes the triangles as 3D Studio file (3DS) with coordinates of float32, about 7 digits; the
/// caller commits the file. Its objects are named part001, part002, ...: each holds at most 65,535
/// points and as many triangles, and points between two of them are repeated. Points that no
/// triangle uses, colours and normals are not written. The same model gives the same bytes.
///
/// Throws Error badInput without triangles; Error limit for coordinates beyond float32 and for a
/// file of 4 GiB or more. Phase "write".
void writeAutodesk3ds(const Model& model, OutputFile& file, Execution& execution);

} // namespace scan
